"""Buildings on open ground as values: rows and kinds of them, their grammar, city models."""
