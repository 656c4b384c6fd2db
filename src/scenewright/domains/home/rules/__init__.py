"""What homes are held to, as tables of rows by room."""
