"""Sorting vectors into classes: online by resonance or leaders, offline by Ward and k-means."""
