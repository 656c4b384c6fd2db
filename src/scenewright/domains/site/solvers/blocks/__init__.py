"""Layouts of one block: rows, rims and courts, by construction inside and apart."""
