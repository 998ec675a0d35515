"""The four named records of the paper that come with the package."""

import pytest

from dcfp.motion import named_motion


@pytest.fixture(scope="session", params=["KNA", "NCC", "LPG", "IVD"])
def record(request):
    return named_motion(request.param)
