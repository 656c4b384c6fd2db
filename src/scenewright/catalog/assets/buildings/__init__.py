"""Buildings, what they are put together from, and what stands between them."""
