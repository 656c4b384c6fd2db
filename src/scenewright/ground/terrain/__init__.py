"""Terrain: heights read, ground shaped for ways and buildings, scenes lifted onto it."""
