"""Homes changed by hand and solved again where that touches."""
