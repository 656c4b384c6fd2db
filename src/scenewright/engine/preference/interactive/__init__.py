"""Interactive genetic algorithms: a person rates layouts in stars, generation by generation."""
