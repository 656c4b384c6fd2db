"""Seats: chairs at tables, lounges, audiences, and whether one can get to them."""
