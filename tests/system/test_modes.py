"""Modes from a file: the stiffness that they are of, what they leave out, and what is wrong with a file."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from dcfp import InputError
from dcfp.system.modes import ModeShapes, read_modes
from dcfp.system.plan import Plan, grid
from dcfp.system.storeys import Storey

PLACES = grid([0.0, 6000.0, 12000.0], [0.0, 6000.0])
STOREYS = (
    Storey(800.0, (9e5, 7e5), 4000.0, centre=(6300.0, 3000.0)),
    Storey(700.0, (8e5, 6e5), 3500.0, stiffness_centre=(5000.0, 3000.0)),
    Storey(500.0, (6e5, 5e5), 3500.0),
)
PLAN = Plan(PLACES, storeys=STOREYS, centre=(6100.0, 3100.0), mass=2600.0)


def written(plan: Plan, folder: Path, count: int) -> Path:
    """The modes of a plan as a frame program prints them: at the centre of mass of each floor, to five digits."""
    structure = plan.structure
    frequencies, shapes = structure.modes
    lines = ["mode,period [s],floor,ux [mm],uy [mm],rz [rad]"]
    for mode in range(count):
        own = shapes[:, mode].reshape(-1, 3)
        for floor, (x, y, turn) in enumerate(own):
            a, b = np.subtract(plan.storeys[floor].centre or plan.mass_centre, plan.mass_centre)
            shape = 100.0 * np.array([x - b * turn, y + a * turn, turn])
            numbers = ",".join(f"{one:.5g}" for one in shape)
            lines.append(f"{mode + 1},{2 * np.pi / frequencies[mode]:.7g},{floor + 1},{numbers}")
    path = folder / "modes.csv"
    path.write_text("\n".join(lines) + "\n")
    return path


def with_modes(plan: Plan, path: Path) -> Plan:
    bare = tuple(replace(one, stiffness=None, stiffness_centre=None) for one in plan.storeys)
    return replace(plan, storeys=bare, modes=read_modes(path, bare))


def test_all_modes_are_the_storeys(tmp_path: Path) -> None:
    found = with_modes(PLAN, written(PLAN, tmp_path, 9))
    np.testing.assert_allclose(found.structure.periods, PLAN.structure.periods, rtol=1e-6)
    scale = np.sqrt(np.diag(PLAN.structure.stiffness))
    np.testing.assert_allclose(
        found.structure.stiffness / np.outer(scale, scale), PLAN.structure.stiffness / np.outer(scale, scale), atol=2e-4
    )  # fmt: skip


def test_a_few_modes_leave_the_rest_rigid(tmp_path: Path) -> None:
    found = with_modes(PLAN, written(PLAN, tmp_path, 4))
    np.testing.assert_allclose(found.structure.periods[:4], PLAN.structure.periods[:4], rtol=1e-6)
    np.testing.assert_allclose(found.structure.periods[4:], PLAN.structure.periods[3] / 10.0, rtol=1e-6)


def test_they_turn_with_the_plan_and_stay_where_they_are_under_accidental_eccentricity(
    tmp_path: Path,
) -> None:
    found = with_modes(PLAN, written(PLAN, tmp_path, 9))
    np.testing.assert_allclose(found.turned(40.0).structure.periods, PLAN.structure.periods, rtol=1e-6)
    moved = replace(found, eccentricity=(0.05, 0.05))
    storeys = tuple(replace(one, stiffness_centre=one.stiffness_centre or PLAN.middle) for one in STOREYS)
    of_storeys = replace(PLAN, storeys=storeys, eccentricity=(0.05, 0.05))
    np.testing.assert_allclose(moved.structure.periods, of_storeys.structure.periods, rtol=1e-4)
    assert abs(moved.structure.periods[0] / PLAN.structure.periods[0] - 1.0) > 1e-4


def test_modes_of_other_masses_are_refused(tmp_path: Path) -> None:
    path = written(PLAN, tmp_path, 6)
    text = (
        path.read_text()
        .replace("rz [rad]", "rz [rad]")
        .replace("ux [mm]", "ux [m]")
        .replace("uy [mm]", "uy [m]")
    )
    path.write_text(text)
    with pytest.raises(InputError, match="are not orthogonal with the masses"):
        _ = with_modes(PLAN, path).structure


HEAD = "mode,period [s],floor,ux [mm],uy [mm],rz [rad]\n"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "the file is empty"),
        (HEAD, "there are 0 lines of modes"),
        (HEAD.replace("ux [mm]", "ux") + "1,0.5,1,1,0,0\n", "the column 'ux' has no unit"),
        (HEAD.replace(",rz [rad]", "") + "1,0.5,1,1,0\n", "names no column 'rz [rad]'"),
        (HEAD + "1,0.5,1,1,0,0\n", "floor 2 of mode 1 is missing"),
        (HEAD + "1,0.5,1,1,0,0\n1,0.5,1,1,0,0\n", "line 3: floor 1 of mode 1 is there twice"),
        (HEAD + "1,0.5,1,1,0,0\n1,0.6,2,1,0,0\n", "line 3: the period of mode 1"),
        (HEAD + "1,-0.5,1,1,0,0\n", "line 2: the period of mode 1"),
        (HEAD + "1,0.5,3,1,0,0\n", "line 2: floor must be a whole number from 1 to 2, not 3"),
        (HEAD + "1,0.5,1,a,0,0\n", "line 2: the ux is 'a', not a number"),
    ],
)
def test_what_is_wrong_is_said(text: str, words: str, tmp_path: Path) -> None:
    path = tmp_path / "modes.csv"
    path.write_text(text)
    with pytest.raises(InputError) as caught:
        read_modes(path, (Storey(1.0), Storey(1.0)))
    assert words in str(caught.value)


def test_a_plan_has_modes_or_stiffnesses() -> None:
    shapes = ModeShapes(np.array([0.5]), np.ones((1, 1, 3)))
    with pytest.raises(InputError, match="has no stiffness"):
        Plan(PLACES, storeys=(Storey(10.0),))
    with pytest.raises(InputError, match="leave one of the two out"):
        Plan(PLACES, storeys=(Storey(10.0, 1e5),), modes=shapes)
    with pytest.raises(InputError, match="are of 1 floors"):
        Plan(PLACES, storeys=(Storey(10.0), Storey(10.0)), modes=shapes)
