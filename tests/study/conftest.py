"""Small studies: records of a few seconds, so that a whole study takes milliseconds."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import xarray

from dcfp import GroundMotion
from dcfp.motion.ground_motion import Origin
from dcfp.study import Study, run_study


def _motion(name: str, seconds: float, period: float) -> GroundMotion:
    time = np.arange(int(seconds / 0.01) + 1) * 0.01
    wave = 3000.0 * np.sin(2.0 * np.pi * time / period) * np.sin(np.pi * time / seconds)
    return GroundMotion(wave - wave.mean(), 0.01, name, Origin(event=f"Event of {name}"))


@pytest.fixture(scope="session")
def motions() -> list[GroundMotion]:
    return [_motion("short", 3.0, 0.8), _motion("long", 6.0, 1.5), _motion("middle", 4.0, 1.1)]


#: Blocks of the grid below: more cost time, and show nothing more.
BLOCKS = 12


def grid(motions: list[GroundMotion]) -> Study:
    """A grid of 3 records, 8 PGVs, 3 coefficients and 2 temperatures."""
    factors = {
        "pgv": np.linspace(100.0, 800.0, 8),
        "mu": [0.04, 0.075, 0.1],
        "ambient": [20.0, -10.0],
    }
    return Study(motions=motions, factors=factors, title="A grid")


@pytest.fixture
def study(motions: list[GroundMotion], monkeypatch: pytest.MonkeyPatch) -> Study:
    """The grid, in fewer blocks than it would have."""
    monkeypatch.setattr("dcfp.study.study.FEWEST_BLOCKS", BLOCKS)
    return grid(motions)


def files(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.fixture(scope="session")
def content() -> Callable[[Path], dict[str, bytes]]:
    """Every file of a folder, by its name in it."""
    return files


@pytest.fixture(scope="session")
def results(motions: list[GroundMotion]) -> xarray.Dataset:
    """The results of the grid, in memory."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("dcfp.study.study.FEWEST_BLOCKS", BLOCKS)
        return run_study(grid(motions))


@pytest.fixture(scope="session")
def whole(motions: list[GroundMotion], tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """Every file of the store of the grid, run at one go."""
    place = tmp_path_factory.mktemp("whole") / "whole.zarr"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("dcfp.study.study.FEWEST_BLOCKS", BLOCKS)
        run_study(grid(motions), place)
    return files(place)


@pytest.fixture
def store(whole: dict[str, bytes], tmp_path: Path) -> Path:
    """The store of the grid, which costs nothing to run again."""
    place = tmp_path / "s.zarr"
    for name, text in whole.items():
        (place / name).parent.mkdir(parents=True, exist_ok=True)
        (place / name).write_bytes(text)
    return place


@pytest.fixture
def record_file(tmp_path: Path) -> Path:
    """A plain file of time and acceleration [m/s2]."""
    time = np.arange(301) * 0.01
    wave = 3.0 * np.sin(2.0 * np.pi * time) * np.sin(np.pi * time / 3.0)
    path = tmp_path / "pulse.txt"
    rows = "".join(f"{t:.2f} {a:.9g}\n" for t, a in zip(time, wave, strict=True))
    path.write_text(f"# time [s], acceleration [m/s2]\n{rows}", encoding="utf-8")
    return path
