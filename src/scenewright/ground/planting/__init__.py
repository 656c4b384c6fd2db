"""Trees and lamps of open ground: where they stand, how densely, and their pieces."""
