"""What a hall is to hold: checked, filled in, split by how it comes to stand."""
