"""Drawings as DXF (ezdxf): layers, blocks, dimensions and layouts, by what the marks stand for."""
