"""Beds and wardrobes, put in or changed for others."""
