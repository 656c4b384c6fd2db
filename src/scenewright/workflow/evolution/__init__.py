"""One evolution: its log, its population, what is shown, and the session that ties them."""
