"""What another package adds to the tables: one file and one row each."""
