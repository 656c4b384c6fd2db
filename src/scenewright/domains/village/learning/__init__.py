"""What is learned of real blocks: how many houses, their classes, and how they stand."""
