"""Kitchens made to measure for a room: where they may stand, of which lines, what each costs."""
