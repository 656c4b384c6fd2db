"""What a household needs of its home: owed by who lives there, counted in its furniture."""
