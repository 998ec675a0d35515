"""The one place that says how kernels are compiled and where the result is kept.

Numba keeps compiled code in a folder and looks only at the file of the compiled function to tell whether
it is still valid: an edited callee in another file is not noticed. Here the folder's name carries a digest of
every kernel source and of the versions of numba and LLVM, so that any edit opens a new folder.
"""

import contextlib
import hashlib
import os
from collections.abc import Callable, Generator
from functools import cache
from pathlib import Path
from typing import Any, ParamSpec, TypeVar

import llvmlite
import numba
import platformdirs
from numba.core import config

P = ParamSpec("P")
R = TypeVar("R")

numba_config: Any = config  # numba fills it at run time, out of sight of a type checker
njit: Any = numba.njit


@cache
def cache_folder() -> str:
    """Return the folder for compiled kernels, or an empty string where none can be written."""
    digest = hashlib.sha256(f"{numba.__version__} {llvmlite.__version__}".encode())
    for source in sorted(Path(__file__).parent.glob("*.py")):
        digest.update(source.name.encode() + source.read_bytes())
    root = os.environ.get("DCFP_CACHE_DIR") or platformdirs.user_cache_dir("dcfp", appauthor=False)
    folder = Path(root) / "kernels" / digest.hexdigest()[:16]
    probe = folder / f".probe-{os.getpid()}"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        probe.touch()
        probe.unlink(missing_ok=True)
    except OSError:
        return ""
    return str(folder)


@contextlib.contextmanager
def _caching_in(folder: str) -> Generator[None]:
    previous = numba_config.CACHE_DIR
    numba_config.CACHE_DIR = folder
    try:
        yield
    finally:
        numba_config.CACHE_DIR = previous


def _compile(function: Callable[P, R], *, reassociate: bool) -> Callable[P, R]:
    folder = cache_folder()
    with _caching_in(folder):
        return njit(
            cache=bool(folder),
            nogil=True,
            error_model="numpy",  # a division by zero is an infinity, not a branch in every division
            fastmath={"contract", "reassoc", "nsz"} if reassociate else {"contract"},
            forceinline=True,  # a call with structures as arguments costs more than most kernels do
            _nrt=False,  # no reference counts: kernels neither make nor keep arrays, and atomic counting took 3/4 of the time
        )(function)


def kernel(function: Callable[P, R]) -> Callable[P, R]:
    """Compile `function` on its first call; keep the result for later processes where a folder allows it.

    A kernel works on numbers and on arrays that it is given; it cannot make an array.
    """
    return _compile(function, reassociate=False)


def reassociating_kernel(function: Callable[P, R]) -> Callable[P, R]:
    """Like `kernel`, with leave to add terms in any order: for sums over an array, which then use all lanes."""
    return _compile(function, reassociate=True)
