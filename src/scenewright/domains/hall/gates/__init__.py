"""Gates, rails and ropes that guide visitors."""
