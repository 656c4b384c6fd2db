"""What buildings are made of: walls with their openings cut, gables, joinery, stairs."""
