"""Run the command line in this process, and small record files for it."""

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from dcfp.cli.main import main


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


def _write(path: Path, time: np.ndarray, acceleration: np.ndarray) -> Path:
    np.savetxt(path, np.column_stack((time, acceleration)), fmt="%.6f")
    return path
