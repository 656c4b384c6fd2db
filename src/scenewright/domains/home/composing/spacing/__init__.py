"""What of a finished home stands too near to something else, and where it goes instead."""
