"""Rooms of a drawing: what lines, arcs and words of a plan mean, whatever file they come from."""
