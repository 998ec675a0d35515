"""What takes long to compute is kept in the build folder for as long as the sources of the package stay the same."""

import hashlib
import json
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import dcfp

BUILD = Path(__file__).parents[1] / "_build" / "kept"


@cache
def _sources() -> str:
    digest = hashlib.sha256()
    root = Path(dcfp.__file__).parent
    for path in sorted(root.rglob("*")):
        if path.suffix in (".py", ".toml", ".bib"):
            digest.update(path.relative_to(root).as_posix().encode())
            digest.update(path.read_bytes())
    return digest.hexdigest()


def kept(name: str, make: Callable[[], Any]) -> Any:
    """Return what `make` returns, as JSON can hold it; from the disk if it was made from the same sources."""
    key = hashlib.sha256(f"{_sources()} {name}".encode()).hexdigest()[:24]
    path = BUILD / f"{key}.json"
    if path.exists():
        return json.loads(path.read_text(encoding="utf-8"))
    made = make()
    BUILD.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(made), encoding="utf-8")
    return made
