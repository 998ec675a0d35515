"""Versions of what makes the numbers and the pages, besides this package."""

import platform
from importlib.metadata import PackageNotFoundError, version

#: Packages by their names in the report; Typst is there only where a PDF can be made.
_PACKAGES = {"NumPy": "numpy", "SciPy": "scipy", "Numba": "numba", "Typst (of the PDF)": "typst"}


def versions() -> dict[str, str]:
    """Return the versions of Python and of the packages that are installed, by their names."""
    found = {"Python": platform.python_version()}
    for name, package in _PACKAGES.items():
        try:
            found[name] = version(package)
        except PackageNotFoundError:  # a page is made without it
            continue
    return found
