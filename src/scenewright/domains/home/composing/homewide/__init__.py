"""What a home has once, put in when all of its rooms stand."""
