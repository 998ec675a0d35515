"""Ground motions: read, named, made, treated and measured."""
