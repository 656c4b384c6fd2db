"""What a model looks like, as numbers: the paper's descriptor, blind to size and turn, and ours."""
