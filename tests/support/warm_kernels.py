"""Compile the kernels that most tests call, so that the processes of a test run find them compiled.

python warm_kernels.py PART ENTRY compiles those of one part; no kernel is in two, so that the parts can run side by side. ENTRY is the module and the
function of the command.
"""

import contextlib
import io
import os
import sys
import tempfile
from importlib import import_module
from pathlib import Path

COMMANDS = ("respond NCC --pgv 0.5", "study run few.toml --out few.zarr", "spectrum NCC --periods 1")
STUDY = '[factors]\nrecord = ["NCC"]\npgv = { values = [0.25, 0.5], unit = "m/s" }\n'


def rigid_structures(entry: str) -> None:
    """Analyse one rigid structure by commands, in a folder of their own, quietly; and march through pulses."""
    module, _, name = entry.partition(":")
    command = getattr(import_module(module), name)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        Path("few.toml").write_text(STUDY, encoding="utf-8")
        for line in COMMANDS:
            with contextlib.redirect_stdout(io.TextIOWrapper(io.BytesIO(), encoding="utf-8")):
                command(line.split())
        os.chdir("/")
    import dcfp

    dcfp.march_through_pulses(dcfp.load_motion("NCC"))
    dcfp.march_in_plane(import_module("dcfp.motion.load").load_record("P695-FF-2"))


def buildings_and_tests(entry: str) -> None:
    """Analyse a building, and test a bearing."""
    import dcfp

    dcfp.run_program(dcfp.load_program("dependency"))
    import_module("dcfp.analysis.rig").run_in_the_plane("plane")
    plan = import_module("dcfp.system.plan").Plan([[0.0, 0.0]])
    import_module("dcfp.analysis.plan").respond_plan(plan, dcfp.load_station("P695-FF-2"))


PARTS = (rigid_structures, buildings_and_tests)

if __name__ == "__main__":
    PARTS[int(sys.argv[1])](sys.argv[2])
