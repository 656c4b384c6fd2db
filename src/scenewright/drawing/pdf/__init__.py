"""Drawings as PDF (fpdf2): vectors in millimetres, selectable text, embedded fonts."""
