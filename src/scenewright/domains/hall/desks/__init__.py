"""Desks, counters and tills: the forms they take, who serves there and who sits at them."""
