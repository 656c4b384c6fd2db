"""From a solved hall to its pieces: walls, objects, what stands on a stage, carpets."""
