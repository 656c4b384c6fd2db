"""What shops, exhibitions, reading rooms and other halls hold."""
