"""Where a group may stand, and in which form: what every move asks."""
