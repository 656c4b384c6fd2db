"""What homes and halls share when they arrange: rows, one verdict, one loop that repairs."""
