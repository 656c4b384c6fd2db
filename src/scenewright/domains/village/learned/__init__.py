"""What a trained net knows of how houses stand: what it sees, and its run without torch."""
