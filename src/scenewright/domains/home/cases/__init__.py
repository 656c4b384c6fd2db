"""The library of cases: shipped, learned, and with furniture of one's own."""
