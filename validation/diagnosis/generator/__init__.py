"""A study with something concealed, from a seed."""
