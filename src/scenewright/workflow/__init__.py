"""What a run does from file to files, as functions that yield events; no terminal is known here."""
