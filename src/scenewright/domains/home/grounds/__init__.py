"""The ground of a room before furniture: walls, cupboards, closets, open plans."""
