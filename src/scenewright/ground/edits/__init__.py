"""Open ground changed by hand, and what of it stays where it stands."""
