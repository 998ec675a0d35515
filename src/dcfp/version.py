"""The version of this package."""

from functools import cache


@cache
def version() -> str:
    """Return the version of the installed package."""
    # late: the import costs more time than the rest of a short command
    from importlib.metadata import PackageNotFoundError
    from importlib.metadata import version as installed_version

    try:
        return installed_version("dcfp")
    except PackageNotFoundError:  # used from its sources without an installation
        return "unknown"
