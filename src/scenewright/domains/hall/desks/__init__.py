"""Desks, counters and tills: the forms they take, their staff and their seats."""
