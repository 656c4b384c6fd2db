"""What a hall lacks of what it was to hold: what cannot fit, what nobody reaches."""
