"""From a solved hall to its pieces: walls, objects, objects on a stage, carpets."""
