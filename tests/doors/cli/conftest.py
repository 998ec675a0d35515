"""Run the command line in this process, and small record files for it."""

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from dcfp.doors.cli.main import main


class Outcome(NamedTuple):
    status: int
    out: str
    err: str


Run = Callable[..., Outcome]


@pytest.fixture
def run(capfd: pytest.CaptureFixture[str]) -> Run:
    """Run ``dcfp`` with words; return its exit status and what it wrote."""

    def call(*words: object) -> Outcome:
        status = main([str(word) for word in words])
        return Outcome(status, *capfd.readouterr())

    return call


@pytest.fixture
def pulse(tmp_path: Path) -> Path:
    """A file of time and acceleration [m/s2]: two seconds of a sine wave and two of rest."""
    time = np.arange(401) * 0.01
    wave = np.where(time <= 2.0, 3.0 * np.sin(2.0 * np.pi * time), 0.0)
    return _write(tmp_path / "pulse.txt", time, wave)


@pytest.fixture
def drifting(tmp_path: Path) -> Path:
    """The same with an offset, as an instrument may have one."""
    time = np.arange(401) * 0.01
    wave = np.where(time <= 2.0, 3.0 * np.sin(2.0 * np.pi * time), 0.0) + 0.4
    return _write(tmp_path / "drifting.txt", time, wave)


@pytest.fixture
def zeros(tmp_path: Path) -> Path:
    """A record in which nothing happens."""
    time = np.arange(201) * 0.01
    return _write(tmp_path / "zeros.txt", time, np.zeros_like(time))


@pytest.fixture
def three_components(tmp_path: Path) -> Path:
    """A file as the Japan Meteorological Agency writes it, with three components."""
    head = (
        "SITE CODE= 47662SENDAI        ,35.69,139.76\n LAT.=   35.6890\n LON.=  139.7559\n SAMPLING RATE= 100Hz\n"
        " UNIT  = gal(cm/s/s)\nINITIAL TIME = 2011 03 11 14 47 10\n NS,EW,UD\n"
    )
    wave = 200.0 * np.sin(0.1 * np.arange(200))
    path = tmp_path / "three.csv"
    path.write_text(head + "".join(f"{value:.3f},{-value:.3f},{value / 2:.3f}\n" for value in wave))
    return path


def _write(path: Path, time: np.ndarray, acceleration: np.ndarray) -> Path:
    np.savetxt(path, np.column_stack((time, acceleration)), fmt="%.6f")
    return path
