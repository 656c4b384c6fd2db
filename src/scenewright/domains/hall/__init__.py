"""Halls: exhibitions, shops, reading rooms, auditoria."""
