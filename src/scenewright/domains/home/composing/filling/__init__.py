"""What is added to a composed room until it is as full as its floor asks for."""
