"""Kitchens made to measure for a room: where they may stand, their lines, what each costs."""
