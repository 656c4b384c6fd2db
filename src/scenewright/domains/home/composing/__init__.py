"""What is better composed where it can be, once a room is furnished: sizes, places, sides."""
