"""Attempts at a room: one whole, several drafts, piece by piece, beds or the kitchen first."""
