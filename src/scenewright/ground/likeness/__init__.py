"""Is it the same place? What two built scenes share and where they differ, measured."""
