"""PROJECT.toml: what it reads to, and one sentence with the line for whatever is wrong."""

from pathlib import Path

import numpy as np
import pytest

from dcfp import InputError
from dcfp.constants import STANDARD_GRAVITY
from dcfp.system.plan import Plan
from dcfp.system.project import read_plan
from dcfp.system.storeys import MODAL

TEXT = """name = "Hospital"

[bearing.A]
slider = 400
[bearing.A.friction]
law = "li2020"

[plan]
grid = { x = [0, 6, 12, 18, 24, 30], y = [0, 6, 12, 18], type = "A" }

[building]
weight = "120 MN"
eccentricity = [0.05, 0.05]
height = 0.5
fixed_base_period = 0.9
damping = 0.02

[[storey]]
count = 9
height = 4
weight = "12 MN"
stiffness = 1000
"""


def read(folder: Path, *changes: tuple[str, str]) -> Plan:
    text = TEXT
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    path = folder / "project.toml"
    path.write_text(text)
    return read_plan(path)


def test_a_project_is_the_building_that_it_says(tmp_path: Path) -> None:
    plan = read(tmp_path)
    assert (plan.name, plan.count, len(plan.storeys)) == ("Hospital", 24, 9)
    assert plan.weight == pytest.approx(120e6)
    assert plan.places[7].tolist() == [6000.0, 6000.0]
    assert plan.mass_centre == pytest.approx((15e3 + 1.5e3, 9e3 + 0.9e3))
    assert plan.structure.periods[0] == pytest.approx(0.9)
    assert plan.storeys[0].mass == pytest.approx(12e6 / STANDARD_GRAVITY)
    assert plan.structure.heights.tolist() == [4000.0 * i for i in range(1, 10)]


def test_a_type_without_pressure_is_at_the_mean_load_of_its_bearings(tmp_path: Path) -> None:
    plan = read(tmp_path)
    pressure = 120e6 / 24 / (np.pi * 200.0**2)
    assert plan.systems[0].bearing.pressure == pytest.approx(pressure)
    np.testing.assert_allclose(plan.elastic_stiffnesses.mean(), 1.9e6)
    given = read(tmp_path, ("slider = 400", "slider = 400\npressure = 60"))
    assert given.systems[0].bearing.pressure == 60.0


def test_bearings_of_several_types_in_a_grid_and_a_list(tmp_path: Path) -> None:
    rows = '[["A", "A"], ["B", "A"]]'
    plan = read(
        tmp_path,
        ("x = [0, 6, 12, 18, 24, 30], y = [0, 6, 12, 18]", "x = [0, 6], y = [0, 6]"),
        ('type = "A" }', f'type = {rows} }}\nbearings = [{{ x = 3, y = "3000 mm", type = "B" }}]'),
        ("[plan]", '[bearing.B]\nradius = ["1 km"]\nslider = 300\nfriction = { law = "constant", mu = 0.1 }\n[plan]'),
    )  # fmt: skip
    assert [one.bearing.name for one in plan.systems] == ["A", "A", "B", "A", "B"]
    assert plan.places[4].tolist() == [3000.0, 3000.0]
    assert plan.radii[4] == 1e6


def test_mass_damping_and_places_of_their_own(tmp_path: Path) -> None:
    plan = read(
        tmp_path,
        ('weight = "120 MN"', "mass = 12000"),
        ("eccentricity = [0.05, 0.05]", 'centre = [14, 9]\nsides = [32, 20]\nslab_centre = [15.5, 9]\ndamping_kind = "modal"'),
        ('weight = "12 MN"', "mass = 1200"),
        ("stiffness = 1000", 'stiffness = [1000, "900 kN/mm"]\ncentre = [14.5, 9]'),
    )  # fmt: skip
    assert plan.mass == 12000.0
    assert plan.damping_kind == MODAL
    assert plan.corners[0].tolist() == [-500.0, -1000.0]
    assert plan.storeys[3].centre == (14500.0, 9000.0)
    assert plan.storeys[0].stiffnesses[1] / plan.storeys[0].stiffnesses[0] == pytest.approx(0.9)


GRID = 'grid = { x = [0, 6, 12, 18, 24, 30], y = [0, 6, 12, 18], type = "A" }'


def listed(one: str) -> str:
    """A grid, and a list with a second bearing."""
    return GRID + f'\nbearings = [{{ x = 1, y = 2, type = "A" }},\n  {one}]'


WRONG = {
    "no bearings": ((GRID, ""), 8, "the plan has no bearings"),
    "another key": (("grid =", "grit ="), 9, "did you mean 'grid'?"),
    "loads that are not the weight": (('type = "A"', 'type = "A", load = "4 MN"'), 12, "sum to 96000 kN, and the building weighs 120000 kN"),
    "a bearing outside": (("[building]", '[building]\nsides = [20, 18]'), 9, "stands outside the slab, which reaches from (5, 0) m to (25, 18) m"),
    "a bearing of the list outside": (("[plan]\n" + GRID + "\n\n[building]", "[plan]\n" + listed('{ x = 50, y = 6, type = "A" }') + "\n[building]\nsides = [30, 20]"), 11, "Bearing 26 at (50, 6) m"),
    "a centre outside": (("eccentricity = [0.05, 0.05]", "centre = [40, 9]"), 13, "The centre of mass, (40, 9) m, lies outside the slab"),
    "a centre of a storey outside": (("stiffness = 1000", "stiffness = 1000\ncentre = [1600, 9]"), 11, "The centre of mass of storey 1, (1600, 9) m, lies outside the slab"),
    "a centre that lifts": (("eccentricity = [0.05, 0.05]", "centre = [29, 9]"), 13, "would lift off at rest"),
    "a negative storey": (("height = 4\n", "height = -4\n"), 20, "[[storey]] 1: height"),
    "a negative mass": (('weight = "12 MN"', "mass = -3"), 21, "[[storey]] 1: mass"),
    "no stiffness": (("stiffness = 1000", ""), 18, "stiffness is missing"),
    "floors heavier than all": (('weight = "120 MN"', 'weight = "100 MN"'), 12, "The floors' masses sum to"),
    "no such type": (('type = "A"', 'type = "B"'), 9, "there is no type of bearing 'B'; the project has A."),
    "no such law": (('law = "li2020"', 'law = "li2021"'), 5, "[bearing.A.friction]: there is no friction law 'li2021'"),
    "no such parameter of a bearing": (("slider = 400", "slidr = 400"), 4, "did you mean 'slider'?"),
    "a slider too small": (("slider = 400", "slider = 12"), 3, "under the mean load of its bearings, 5000 kN"),
    "no weight": (('weight = "120 MN"', ""), 11, "give the weight of the building"),
    "weight and mass": (('weight = "120 MN"', 'weight = "120 MN"\nmass = 3'), 12, "give either weight or mass, not both"),
    "not a weight": (('weight = "120 MN"', 'weight = "120 m"'), 12, "with which 'm' is not compatible"),
    "no place": ((GRID, listed('{ x = 3, type = "A" }')), 11, "y is missing"),
    "a place twice": ((GRID, listed('{ x = 6, y = 6, type = "A" }')), 11, "bearings 8 and 26 both stand at (6, 6) m"),
    "a load for one": ((GRID, listed('{ x = 3, y = 3, type = "A", load = 1e3 }')), 9, "give the load of every bearing or of none"),
    "a damping of two": (("damping = 0.02", "damping = 2"), 16, "were % meant?"),
    "a damping of another kind": (("damping = 0.02", 'damping_kind = "rayleigh"'), 16, "must be one of stiffness, modal"),
    "one storey": (("[[storey]]", "[storey]"), 18, "storeys are written [[storey]]"),
    "another part": (("[building]", "[house]\n[building]"), 11, "there is no part of a project 'house'"),
}  # fmt: skip


@pytest.mark.parametrize("case", WRONG)
def test_whatever_is_wrong_is_said_with_its_line(case: str, tmp_path: Path) -> None:
    change, line, words = WRONG[case]
    with pytest.raises(InputError) as caught:
        read(tmp_path, change)
    sentence = str(caught.value)
    assert f"project.toml, line {line}: " in sentence
    assert words in sentence


def test_a_mark_of_the_byte_order_and_ends_of_lines_of_windows(tmp_path: Path) -> None:
    path = tmp_path / "project.toml"
    path.write_bytes(b"\xef\xbb\xbf" + TEXT.replace("\n", "\r\n").encode())
    assert read_plan(path).count == 24


def test_what_is_nested_too_deep_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "project.toml"
    path.write_text("x = " + "[" * 5000 + "]" * 5000)
    with pytest.raises(InputError, match="too deep to be read"):
        read_plan(path)


def test_a_period_without_storeys_is_refused(tmp_path: Path) -> None:
    text = TEXT[: TEXT.index("[[storey]]")]
    (tmp_path / "project.toml").write_text(text)
    with pytest.raises(InputError, match=r"line 15: .*fixed_base_period is of storeys"):
        read_plan(tmp_path / "project.toml")
