"""Observations: what cameras at eye height in a scene see, as colour, depth, masks and normals."""
