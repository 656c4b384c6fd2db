"""How one walks through a home: its free floor, what bars a way, and what gives way."""
