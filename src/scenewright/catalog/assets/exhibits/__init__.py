"""Large single things to be shown: vehicles, skeletons, sculptures, stands."""
