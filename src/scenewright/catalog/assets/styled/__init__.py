"""Furniture in styles: one module a theme, each drawing its kinds once a form of a style."""
