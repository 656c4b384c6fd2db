"""Furniture on patches: cases tried piece by piece, put straight, with lamps and curtains."""
