"""Pieces of a glTF document: surfaces and how they are packed, materials with their textures."""
