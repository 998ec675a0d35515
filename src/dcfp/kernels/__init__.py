"""The compiled layer: numbers and arrays in N, mm, s, degC; imports nothing of the package but itself."""
