"""File formats of recorded ground motions: one module for each, found by content."""
