"""What all tests share."""

from hypothesis import settings

# the first call of a kernel compiles it, which takes longer than any deadline
settings.register_profile("dcfp", deadline=None)
settings.load_profile("dcfp")
