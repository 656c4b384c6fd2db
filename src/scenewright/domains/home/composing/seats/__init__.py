"""Seats and what they look at, placed together."""
