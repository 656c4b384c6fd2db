"""Files in and out: one file a format, found by suffix.

A row says which suffix a module handles and whether it reads briefs or writes solutions; the
module is imported on first use, so a missing extra is only noticed (and named) then.
"""
