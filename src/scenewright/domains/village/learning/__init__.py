"""What is learned of real blocks: how many houses, of which classes, and how they stand."""
