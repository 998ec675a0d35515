"""Compile the kernels that most tests call, so that the processes of a test run find them compiled.

python warm_kernels.py PART runs the commands of one part; the parts compile different kernels, and so can run side by side.
"""

import contextlib
import io
import os
import sys
import tempfile
from importlib import import_module
from pathlib import Path

PARTS = (
    ("respond NCC --pgv 0.5", "building NCC --pgv 0.5"),
    (
        "test dependency",
        "study run few.toml --out few.zarr",
        "predict NCC --pgv 0.5",
        "spectrum NCC --periods 1",
    ),
)
STUDY = '[factors]\nrecord = ["NCC"]\npgv = { values = [0.25, 0.5], unit = "m/s" }\n'


def run(part: int, entry: str) -> None:
    """Run the commands of a part in a folder of their own, quietly."""
    module, _, name = entry.partition(":")
    command = getattr(import_module(module), name)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        Path("few.toml").write_text(STUDY, encoding="utf-8")
        for line in PARTS[part]:
            with contextlib.redirect_stdout(io.TextIOWrapper(io.BytesIO(), encoding="utf-8")):
                command(line.split())
        os.chdir("/")


if __name__ == "__main__":
    run(int(sys.argv[1]), sys.argv[2])
