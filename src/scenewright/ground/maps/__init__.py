"""Features of maps: geometry, tags, levels, place, and what became of each."""
