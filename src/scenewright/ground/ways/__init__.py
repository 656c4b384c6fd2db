"""Ways on open ground: lanes, walks to doors, and what they are paved with."""
