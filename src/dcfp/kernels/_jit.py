"""The one place that says how kernels are compiled and where the result is kept.

Numba keeps compiled code in a folder and looks only at the file of the compiled function to tell whether
it is still valid: an edited callee in another file is not noticed. Here the folder's name carries a digest of
every kernel source and of the numba version, so that any edit opens a new folder.
"""

import contextlib
import hashlib
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import ParamSpec, TypeVar

import llvmlite
import numba
import platformdirs
from numba.core import config as numba_config

P = ParamSpec("P")
R = TypeVar("R")


@cache
def cache_folder() -> str:
    """Return the folder for compiled kernels, or an empty string where none can be written."""
    digest = hashlib.sha256(f"{numba.__version__} {llvmlite.__version__}".encode())
    for source in sorted(Path(__file__).parent.glob("*.py")):
        digest.update(source.read_bytes())
    folder = Path(platformdirs.user_cache_dir("dcfp", appauthor=False)) / "kernels" / digest.hexdigest()[:16]
    try:
        folder.mkdir(parents=True, exist_ok=True)
        probe = folder / f".probe-{hashlib.sha256(str(id(folder)).encode()).hexdigest()[:8]}"
        probe.touch()
        probe.unlink(missing_ok=True)
    except OSError:
        return ""
    return str(folder)


@contextlib.contextmanager
def _caching_in(folder: str) -> Iterator[None]:
    previous: str = numba_config.CACHE_DIR
    numba_config.CACHE_DIR = folder
    try:
        yield
    finally:
        numba_config.CACHE_DIR = previous


def _compile(function: Callable[P, R], *, reassociate: bool) -> Callable[P, R]:
    folder = cache_folder()
    allowed = {"contract", "reassoc", "nsz"} if reassociate else {"contract"}
    with _caching_in(folder):
        compiled: Callable[P, R] = numba.njit(
            cache=bool(folder), _nrt=False, forceinline=function.__name__ not in ("march","write_profile"), nogil=True, error_model="numpy", fastmath=allowed
        )(function)
    return compiled


def kernel(function: Callable[P, R]) -> Callable[P, R]:
    """Compile `function` on its first call; keep the result for later processes where a folder allows it."""
    return _compile(function, reassociate=False)


def reassociating_kernel(function: Callable[P, R]) -> Callable[P, R]:
    """Like `kernel`, with leave to add terms in any order: for sums over an array, which then use all lanes."""
    return _compile(function, reassociate=True)
