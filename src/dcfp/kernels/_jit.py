"""The one place that says how kernels are compiled and where the result is kept.

Numba looks only at the file of the compiled function to tell whether its code is still valid: an edited callee in another file is not noticed. Here the
folder's name carries a digest of every kernel source and of all else that the code depends on, so that any edit opens a new folder.
"""

import contextlib
import hashlib
import os
import shutil
import tempfile
import time
from collections.abc import Callable, Generator
from functools import cache
from pathlib import Path
from typing import Any, ParamSpec, TypeAlias, TypeVar, cast, get_type_hints

import llvmlite
import numba
import numpy as np
import platformdirs
from numba.core import config
from numba.core.caching import FunctionCache
from numba.extending import intrinsic, is_jitted

P = ParamSpec("P")
R = TypeVar("R")

# numba makes these at run time, out of sight of a type checker
numba_config: Any = config
njit: Any = numba.njit
numba_types: Any = numba.types

#: A folder of compiled kernels that no process has opened for so long is deleted [s].
LONGEST_DISUSE = 60 * 24 * 3600.0


class _KernelCache(FunctionCache):
    """Numba's store of compiled code, made indifferent to damage.

    What cannot be read is compiled again and what cannot be written is not kept: a full disk, a folder that has gone or
    a file cut short must not fail an analysis.
    """

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """Return the code kept for the argument types `sig`, or None."""
        try:
            found = cast("Any", super()).load_overload(sig, target_context)
            # of two processes that save code for different types at once, one may overwrite the other's file
            return (
                found
                if found is not None and found.signature.args == tuple(getattr(sig, "args", sig))
                else None
            )
        except Exception:  # unpickling a damaged file can raise anything
            with contextlib.suppress(OSError):
                self.flush()
            return None

    def save_overload(self, sig: Any, data: Any) -> None:
        """Keep the code `data`, compiled for the argument types `sig`."""
        # it reads the index first, which may be damaged
        with contextlib.suppress(Exception):
            super().save_overload(sig, data)


class LawCache(_KernelCache):
    """The store of one law, in a folder of its own whose name says all that the law does."""

    def _index_key(self, sig: Any, codegen: Any) -> Any:
        return sig, codegen.magic_tuple()


def source_digest() -> str:
    """Return the SHA-256 of the sources of all kernels."""
    digest = hashlib.sha256()
    for source in sorted(Path(__file__).parent.glob("*.py")):
        digest.update(source.name.encode() + hashlib.sha256(source.read_bytes()).digest())
    return digest.hexdigest()


def _digest() -> str:
    """Return a name for all that compiled code depends on, apart from the processor, which numba minds itself."""
    switches = (numba_config.OPT, numba_config.BOUNDSCHECK)
    whole = f"{numba.__version__} {llvmlite.__version__} {switches} {source_digest()}"
    return hashlib.sha256(whole.encode()).hexdigest()[:16]


def _delete_disused(root: Path) -> None:
    """Delete the folders that earlier versions of the kernels left behind."""
    for folder in root.glob("[0-9a-f]" * 16):
        with contextlib.suppress(OSError):
            if time.time() - folder.stat().st_mtime > LONGEST_DISUSE:
                shutil.rmtree(folder, ignore_errors=True)


@cache
def cache_folder() -> str:
    """Return the folder for compiled kernels, or an empty string where none can be written."""
    root = Path(os.environ.get("DCFP_CACHE_DIR") or platformdirs.user_cache_dir("dcfp", appauthor=False))
    folder = root.absolute() / "kernels" / _digest()
    try:
        is_new = not folder.exists()
        folder.mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=folder).close()
        os.utime(folder)  # in use: see LONGEST_DISUSE
    except OSError:
        return ""
    if is_new:
        _delete_disused(folder.parent)
    return str(folder)


@contextlib.contextmanager
def caching_in(folder: str) -> Generator[None]:
    """Have stores that are made meanwhile keep their code in `folder`."""
    previous = numba_config.CACHE_DIR
    numba_config.CACHE_DIR = folder
    try:
        yield
    finally:
        numba_config.CACHE_DIR = previous


def _keep(compiled: Any, folder: str) -> None:
    """Let a compiled function be kept in `folder`."""
    with caching_in(folder):
        store: Any = _KernelCache(compiled.py_func)
    if store.cache_path.startswith(folder):  # else numba could not write there, and chose a place of its own
        compiled._cache = store


def kernel(function: Callable[P, R]) -> Callable[P, R]:
    """Compile `function` on its first call; keep the result for later processes where a folder allows it.

    A kernel works on numbers and on arrays that it is given; it cannot make an array.
    """
    return _compiled(function, inline=True)


def called_kernel(function: Callable[P, R]) -> Callable[P, R]:
    """Compile a kernel that is called, not repeated in every place that names it: for long ones, in which a call is soon made up for."""
    return _compiled(function, inline=False)


def _compiled(function: Callable[P, R], *, inline: bool) -> Callable[P, R]:
    compiled = njit(
        nogil=True,
        error_model="numpy",  # a division by zero is an infinity, not a branch in every division
        fastmath={"contract"},  # a multiplication and an addition may be one instruction
        forceinline=inline,  # a call with structures as arguments costs more than most kernels do
        _nrt=False,  # no reference counts: kernels neither make nor keep arrays, and atomic counting took 3/4 of the time
    )(function)
    if is_jitted(compiled) and (folder := cache_folder()):  # not jitted: NUMBA_DISABLE_JIT is set
        _keep(compiled, folder)
    return compiled


#: An array of records, whose fields are those of a class of named tuples and which no type checker knows.
Records: TypeAlias = Any


def record_type(kind: type) -> np.dtype[np.void]:
    """Return the type of a record with the numbers of a class of named tuples; a field of such a class becomes a record within."""
    numbers = {float: np.float64, complex: np.complex128, int: np.int64, bool: np.bool_}
    fields: list[tuple[str, Any]] = []
    for name, hint in get_type_hints(kind).items():
        if hint in numbers:
            fields.append((name, numbers[hint]))
        elif hasattr(hint, "_fields"):
            fields.append((name, record_type(hint)))
    return np.dtype(fields, align=True)


def as_bytes(records: Records) -> Records:
    """Return a view of records without their fields, of which NumPy copies and picks some ten times as fast."""
    return records.view(np.dtype((np.void, records.dtype.itemsize)))


def _fields_interpreted(record: Any) -> tuple[Any, ...]:
    return record.item()


def _fields_compiled(typing: Any, record: Any) -> Any:
    numbers = [record.typeof(name) for name in record.fields]
    result = numba_types.Tuple(numbers)

    def build(context: Any, builder: Any, signature: Any, values: Any) -> Any:
        parts = [
            context.get_getattr(record, name)(context, builder, record, values[0], name)
            for name in record.fields
        ]
        return context.make_tuple(builder, result, parts)

    return result(record), build


def _store_interpreted(record: Any, values: tuple[Any, ...]) -> None:
    for name, value in zip(record.dtype.names, values, strict=True):
        record[name] = value


def _store_compiled(typing: Any, record: Any, values: Any) -> Any:
    def build(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        for i, name in enumerate(record.fields):
            part = builder.extract_value(arguments[1], i)
            part = context.cast(builder, part, values.types[i], record.typeof(name))
            setter = context.get_setattr(name, numba_types.void(record, record.typeof(name)))
            setter(builder, (arguments[0], part))
        return context.get_dummy_value()

    return numba_types.void(record, values), build


#: The numbers of a record without records within, as a tuple.
fields_of: Any = _fields_interpreted if numba_config.DISABLE_JIT else intrinsic(_fields_compiled)
#: Write a tuple into such a record.
store: Any = _store_interpreted if numba_config.DISABLE_JIT else intrinsic(_store_compiled)
