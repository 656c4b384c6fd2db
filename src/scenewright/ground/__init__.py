"""Sites: the valid ground of a brief, what fits on it, and what lies on it."""
