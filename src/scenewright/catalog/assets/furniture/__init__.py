"""What homes hold, and the small things on it."""
