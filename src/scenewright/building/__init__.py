"""Parts of buildings: walls with their openings cut, gables, joinery, stairs."""
