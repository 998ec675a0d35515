"""Physical constants in the package's units (N, mm, s, degC)."""

#: Standard acceleration of gravity [mm/s2]; CGPM 1901, ISO 80000-3.
STANDARD_GRAVITY = 9806.65
