"""The march of the kernels against the same algorithm written by hand in C."""

import ctypes
import os
import shutil
import subprocess
from ctypes import POINTER, Structure, byref, c_double, c_int, c_long, c_size_t
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from figure import Figure
from stopwatch import in_turn, microseconds, once, ratio

from analysis import SINGLE, Analysis, motion_at
from dcfp.arrays import FloatArray
from dcfp.kernels.heat_state import RATES, WEIGHTS
from dcfp.kernels.law import Law
from dcfp.kernels.motion import SystemConstants
from dcfp.kernels.sum_of_exponentials import MODES
from dcfp.system import LI_2020, Bearing, FrictionLaw, Kumar2015, Li2020
from dcfp.system.plates import kernel_model

SOURCE = Path(__file__).parent / "c" / "march.c"
#: The last two let a C compiler do what ours is allowed to: sums in any order, and no errno to set.
FLAGS = ("-O3", "-march=native", "-fopenmp-simd", "-fno-math-errno")
ROUNDS = 300
#: Largest relative difference of the peak displacement [-].
AGREEMENT = 1e-9

Doubles = POINTER(c_double)


class _Law(Structure):
    _fields_ = [(name, c_double) for name in Law._fields[1:]]


class _Structure(Structure):
    _fields_ = [(name, c_long if name == "plates" else c_double) for name in SystemConstants._fields]


class _Steel(Structure):
    _fields_ = [
        ("ambient", c_double),
        ("half_contact", c_double),
        ("instant", c_double),
        ("rates", c_double * MODES),
        ("weights", c_double * MODES),
    ]


class _Outcome(Structure):
    _fields_ = [
        *(
            (name, c_double)
            for name in ("input", "hysteretic", "turning", "peak_displacement", "peak_change")
        ),
        *((name, c_double) for name in ("peak_velocity", "peak_force", "peak_temperature", "least_friction")),
        ("steps", c_double),
    ]


_ARGUMENTS = (
    *(POINTER(_Law), POINTER(_Structure), POINTER(_Steel), c_size_t, Doubles, c_double),
    *(c_int, c_size_t, c_double),
    *(POINTER(_Outcome), c_size_t, Doubles, POINTER(c_size_t)),
)


def compiler() -> str | None:
    """Return a C compiler, if there is one."""
    return shutil.which(os.environ.get("CC", "cc")) or shutil.which("gcc") or shutil.which("clang")


def build(folder: Path, command: str) -> ctypes.CDLL:
    """Compile the C source into `folder` and load it."""
    library = folder / "march.so"
    arguments = [
        command,
        *FLAGS,
        f"-DMODES={MODES}",
        "-shared",
        "-fPIC",
        "-o",
        str(library),
        str(SOURCE),
        "-lm",
    ]
    subprocess.run(arguments, check=True, capture_output=True)
    loaded = ctypes.CDLL(str(library))
    loaded.march.argtypes = _ARGUMENTS
    loaded.march.restype = c_int
    return loaded


def _pointer(values: FloatArray) -> "ctypes._Pointer[c_double]":
    return values.ctypes.data_as(Doubles)


class HandWritten:
    """The C program on the arrays of an `Analysis`."""

    def __init__(self, library: ctypes.CDLL, analysis: Analysis) -> None:
        self.function = library.march
        self.analysis = analysis
        model, row = kernel_model(analysis.system, analysis.at_rest.plates), c_double * MODES
        heat = model.heat
        self.steel = _Steel(
            heat.ambient, heat.half_contact, heat.instant, row(*heat.modes[RATES]), row(*heat.modes[WEIGHTS])
        )
        self.law = _Law(*model.law[1:])
        self.structure = _Structure(*model.system)
        self.lines = np.zeros_like(analysis.lines)
        self.outcome = _Outcome()

    def march(self) -> float:
        """March once through the record; return the time of the call [s]."""
        analysis = self.analysis
        size = analysis.acceleration.size
        arguments = (
            *(byref(self.law), byref(self.structure), byref(self.steel), size),
            *(_pointer(analysis.acceleration), analysis.motion.time_step),
            *(analysis.coarsest, size, analysis.tolerance),
            *(byref(self.outcome), size, _pointer(self.lines), byref(c_size_t())),
        )
        function = self.function
        return once(lambda: function(*arguments))

    def check(self) -> None:
        """Raise unless it does what the kernels do: the same steps to the same displacement."""
        self.analysis.march()
        self.march()
        expected = self.analysis.peak_displacement
        difference = abs(self.outcome.peak_displacement / expected - 1.0)
        if difference > AGREEMENT or self.outcome.steps != self.analysis.steps:
            msg = (
                f"the C program is off by {difference:.1e} with {self.outcome.steps:.0f} steps"
                f" against {self.analysis.steps}"
            )
            raise AssertionError(msg)


def _figures(library: ctypes.CDLL, friction: FrictionLaw, bearing: Bearing, label: str) -> list[Figure]:
    analysis = Analysis(motion_at("NCC"), bearing, friction)
    hand_written = HandWritten(library, analysis)
    try:
        hand_written.check()
    except AssertionError as difference:
        return [Figure(f"march over C, {label}", None, at_most=1.5, note=str(difference))]
    ours, theirs = in_turn([analysis.march, hand_written.march], ROUNDS)
    note = f"{microseconds(ours):.0f} us over {microseconds(theirs):.0f} us, {analysis.steps} steps each"
    return [Figure(f"march over C, {label}", ratio(ours, theirs), at_most=1.5, note=note)]


def figures() -> list[Figure]:
    """Return the ratios of our time to that of the C program."""
    command = compiler()
    if command is None:
        return [Figure("march over C", None, at_most=1.5, note="there is no C compiler here")]
    with TemporaryDirectory() as folder:
        library = build(Path(folder), command)
        return [
            *_figures(library, Li2020(), LI_2020, "Li 2020, double concave"),
            *_figures(library, Kumar2015(), SINGLE, "Kumar 2015, single concave"),
        ]
