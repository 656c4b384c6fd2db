"""The visit: doors, the floor one walks on, the part each group plays, the tour."""
