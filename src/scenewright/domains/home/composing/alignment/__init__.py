"""Pieces along walls put on the axis of what they belong to, against one another, off doors."""
