"""What lies between a street and a house: borders, fronts, plots, parking."""
