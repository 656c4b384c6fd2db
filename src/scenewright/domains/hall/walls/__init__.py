"""Walls of a hall: those that are built, curved ones, corners."""
