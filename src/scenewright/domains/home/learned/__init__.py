"""What furnished homes teach: groups of furniture, distances, free floor, how much."""
