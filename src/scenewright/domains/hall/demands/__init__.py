"""The demands of a hall: checked, filled in, split by how they are laid out."""
