"""The version of this package."""

from functools import cache
from importlib.metadata import PackageNotFoundError
from importlib.metadata import version as installed_version


@cache
def version() -> str:
    """Return the version of the installed package."""
    try:
        return installed_version("dcfp")
    except PackageNotFoundError:  # used from its sources without an installation
        return "unknown"
