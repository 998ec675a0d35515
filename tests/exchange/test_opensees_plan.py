"""The script for OpenSees of a whole building: run in a process of its own, as a stranger would, and compared with the analysis that it repeats."""

import ast
import csv
import os
import re
import subprocess
import sys
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import dcfp
from dcfp import LI_2020, ConstantFriction, Li2020, NoHeating, SimplifiedHeating, System
from dcfp.analysis.plan import respond_plan
from dcfp.errors import InputError
from dcfp.exchange import plan_script
from dcfp.system.modes import ModeShapes
from dcfp.system.plan import Plan, grid
from dcfp.system.storeys import MODAL, STIFFNESS_PROPORTIONAL, Storey

REQUIRED = os.environ.get("DCFP_REQUIRE_OPENSEES") == "1"
CONSTANT = System(LI_2020, ConstantFriction(), NoHeating())
COLD = System(LI_2020, dcfp.Constantinou1990(), NoHeating())
HEATED = System(LI_2020, Li2020(), SimplifiedHeating())
SINGLE = System(dcfp.Bearing((7000.0,), 400.0, 60.0, 1.5e6), ConstantFriction(0.06), NoHeating())
SIX = grid([0.0, 6000.0, 12000.0], [0.0, 8000.0])
MASS = 6 * LI_2020.mass
STOREYS = (
    Storey(MASS / 4, (1.2e6, 0.9e6), 5000.0, stiffness_centre=(5500.0, 4300.0)),
    Storey(MASS / 5, 0.8e6, 4000.0, torsional_stiffness=3e13, inertia=2.5e10, centre=(6800.0, 3900.0)),
)


@cache
def station(vertical: float = 0.0, seconds: float = 5.5) -> dcfp.Station:
    """Return two components at a resultant PGV of 0.5 m/s, and perhaps as the vertical one so many times the first, a little earlier."""
    pair = dcfp.load_station("P695-FF-2").scaled_to_pgv(500.0)
    samples = round(seconds / pair.time_step)
    x, y = (replace(one, acceleration=one.acceleration[:samples]) for one in (pair.x, pair.y))
    up = replace(x, acceleration=vertical * np.roll(x.acceleration, -3)) if vertical else None
    return dcfp.Station(x, y, up, "pair")


def building(types=CONSTANT, **more) -> Plan:
    return Plan(SIX, types, centre=(6300.0, 4200.0), **({"storeys": STOREYS, "height": 1500.0} | more))


def values_of(script: str, name: str):
    """Return a constant of a script."""
    (found,) = (
        ast.literal_eval(node.value)
        for node in ast.parse(script).body
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == name
    )
    return found


def run_script(script: str, folder) -> tuple[dict[str, tuple[float, float]], np.ndarray, list[str]]:
    """Return peaks with those of dcfp, and the history with its heads."""
    (folder / "model.py").write_text(script, encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-I", "model.py"], cwd=folder, capture_output=True, text=True, timeout=300, check=False
    )  # fmt: skip
    if done.returncode and "import openseespy" in done.stderr and not REQUIRED:
        pytest.skip(f"OpenSees cannot be imported: {done.stderr.strip().splitlines()[-1]}")
    assert done.returncode == 0, done.stderr
    told = re.findall(r"^(\S.*?) +(-?[\d.]+) \S+ +\(dcfp: (-?[\d.]+)", done.stdout, re.MULTILINE)
    with (folder / "model_history.csv").open(encoding="utf-8", newline="") as file:
        head, *rows = csv.reader(file)
    return {name: (float(one), float(other)) for name, one, other in told}, np.array(rows, dtype=float), head


@pytest.mark.slow
@pytest.mark.parametrize(
    ("plan", "vertical", "overturning"),
    [
        (building(COLD), 0.0, False),
        (building(COLD).turned(25.0), 0.3, False),
        (building(SINGLE, damping=0.05), 0.3, True),
        (building((HEATED, SINGLE, COLD) * 2, damping_kind=MODAL), 0.0, True),
        (building(SINGLE, storeys=(), height=6000.0), 0.0, True),
    ],
    ids=["velocity", "turned and vertical", "overturning and vertical", "three types", "rigid"],
)
def test_the_script_finds_what_dcfp_finds_for_the_same_friction_and_damping(
    tmp_path, plan, vertical, overturning
) -> None:
    motion = station(vertical)
    script = plan_script(plan, motion, vertical=vertical > 0.0, overturning=overturning, tail=0.0, step=5e-4)
    peaks, history, head = run_script(script, tmp_path)
    expected = [
        "peak displacement", "corner displacement", "rotation", *(f"drift of storey {i}" for i in range(1, 1 + len(plan.storeys))),
        "acceleration of the slab", *(f"acceleration of floor {i}" for i in range(1, 1 + len(plan.storeys))),
        "least load", "largest load", "time without load",
    ]  # fmt: skip
    assert list(peaks) == expected
    # two plates: OpenSees has the horizontal force where the slider is, which turns the slab
    turned = 0.05 if overturning and any(len(one.bearing.radii) == 2 for one in plan.systems) else 0.01
    # the slab's acceleration is known at the samples only
    limits = {
        "peak displacement": 2e-3,
        "corner displacement": 3e-3,
        "rotation": turned,
        "acceleration of the slab": 0.02,
    }
    for name, (found, own) in peaks.items():
        assert found == pytest.approx(own, rel=limits.get(name, 0.01), abs=2e-3), name
    loads = history[:, [i for i, one in enumerate(head) if one.startswith("load")]]
    ratio = 1.0
    if vertical:
        ground = values_of(script, "GROUND_ACCELERATION")[3]
        ratio = 1.0 + np.interp(history[:, 0], np.arange(len(ground)) * motion.time_step, ground) / 9806.65
        assert np.ptp(loads.sum(axis=1)) > 0.1 * plan.weight
    # the first row is before the ground moves
    inside = slice(1, round((len(motion.x.acceleration) - 1) * motion.time_step / history[1, 0]))
    np.testing.assert_allclose((loads.sum(axis=1) / plan.weight / ratio)[inside], 1.0, atol=3e-5)
    if not overturning:
        np.testing.assert_allclose(
            loads[inside] / np.outer(np.ones(len(history)) * ratio, plan.static_loads)[inside], 1.0, atol=3e-5
        )
    # the corners are where the slab's motion puts them
    x, y, turn = history[:, 1:4].T
    for i, (px, py) in enumerate(plan.corners - np.array(plan.mass_centre)):
        column = head.index(f"corner {i + 1} x [mm]")
        np.testing.assert_allclose(history[:, column], x - turn * py, atol=1e-9)
        np.testing.assert_allclose(history[:, column + 1], y + turn * px, atol=1e-9)


def test_the_constants_are_those_of_the_plan() -> None:
    plan, motion = building((CONSTANT, SINGLE) * 3), station()
    script = plan_script(plan, motion, tail=0.0)
    bearings = np.array(values_of(script, "BEARINGS"))
    np.testing.assert_array_equal(bearings[:, :2], plan.places)
    for column, wanted in ((2, plan.static_loads), (3, plan.radii), (4, plan.elastic_stiffnesses)):
        np.testing.assert_allclose(bearings[:, column], wanted)
    np.testing.assert_allclose(bearings[:, 5], [0.043, 0.06] * 3)
    np.testing.assert_array_equal(
        bearings[:, 8], [0.5, 0.0] * 3
    )  # the slider of a single plate stays under the slab
    assert (
        np.array(values_of(plan_script(plan, motion, overturning=False, tail=0.0), "BEARINGS"))[:, 8].max()
        == 0.0
    )
    slab, floors = values_of(script, "SLAB_BODY"), np.array(values_of(script, "FLOORS"))
    assert slab[3] + floors[:, 3].sum() == pytest.approx(plan.total_mass)
    assert slab[:3] == (*plan.mass_centre, 1500.0)
    np.testing.assert_allclose(floors[:, 2], [6500.0, 10500.0])
    assert floors[1].tolist() == [6800.0, 3900.0, 10500.0, MASS / 5, 2.5e10]
    assert values_of(script, "STOREYS")[1] == (6000.0, 4000.0, 0.0, 0.8e6, 0.8e6, 3e13)
    damping = values_of(script, "DAMPING")
    assert damping * plan.structure.modes[0][0] == pytest.approx(2.0 * plan.damping)
    ground = values_of(script, "GROUND_ACCELERATION")
    assert set(ground) == {1, 2}
    np.testing.assert_array_equal(ground[2], motion.y.acceleration)
    assert len(values_of(script, "COLUMNS")) == 4 + 8 + 4 + 6 + 6


def test_what_it_cannot_be_is_said_with_its_size() -> None:
    plan, motion = building(HEATED, damping_kind=MODAL), station()
    script = plan_script(plan, motion, tail=0.0)
    head = " ".join(script[: script.index("import csv")].replace("\n#", " ").split())
    for words in (
        "the mean temperature of each bearing",
        "does not change with the pressure",
        "in proportion to the stiffness, with the same",
    ):
        assert words in head
    own = respond_plan(plan, motion, tail=0.0).peak_displacement
    fast = {row[:2]: row[5] for row in values_of(script, "BEARINGS")}
    assert len(set(fast.values())) == 6  # each at its own pressure and temperature
    types = tuple(
        System(LI_2020, dcfp.exchange.opensees.element.ElementFriction(row[5], 1.0 - row[6] / row[5], row[7], heated=False), NoHeating())
        for row in values_of(script, "BEARINGS")
    )  # fmt: skip
    same = respond_plan(replace(plan, types=types, damping_kind=STIFFNESS_PROPORTIONAL), motion, tail=0.0)
    (printed,) = re.findall(
        r"centre of mass of ([\d.]+) mm, ([\d.]+) % (more|less) than the ([\d.]+) mm", head
    )
    assert float(printed[0]) == pytest.approx(same.peak_displacement, abs=1e-3)
    assert float(printed[3]) == pytest.approx(own, abs=1e-3)
    assert values_of(script, "PEAKS")[0] == (
        "peak displacement",
        "mm",
        pytest.approx(same.peak_displacement),
        own,
    )


def test_friction_at_the_mean_temperature_is_nearer_than_cold() -> None:
    found: list[tuple[float, float]] = []
    cold = System(LI_2020, Li2020(), NoHeating())
    for name in ("P695-FF-2", "P695-FF-5", "P695-FF-14"):
        plan, motion = building(HEATED, storeys=(), height=0.0), dcfp.load_station(name).scaled_to_pgv(500.0)
        (peak, _, exported, own), *_ = values_of(plan_script(plan, motion), "PEAKS")
        assert (peak, own) == ("peak displacement", respond_plan(plan, motion).peak_displacement)
        found.append(
            (
                abs(exported / own - 1.0),
                abs(respond_plan(replace(plan, types=cold), motion).peak_displacement / own - 1.0),
            )
        )
    mean, unheated = np.array(found).mean(axis=0)
    assert mean < 0.75 * unheated


def test_what_is_the_same_is_not_called_different() -> None:
    script = plan_script(building(COLD), station(), overturning=False, tail=0.0)
    assert "It is not what was analysed" not in script
    for _, _, same, own in values_of(script, "PEAKS"):
        assert same == own
    pressed = System(LI_2020, Li2020(temperature_dependent=False), NoHeating())
    assert "It is not what was analysed" not in plan_script(
        building(pressed), station(), overturning=False, tail=0.0
    )
    assert "It is not what was analysed" in plan_script(building(pressed), station(), tail=0.0)


@pytest.mark.parametrize(
    ("plan", "vertical", "words"),
    [
        (building(System(LI_2020, dcfp.Lomiento2013(), NoHeating())), 0.0, "near the friction law lomiento2013"),
        (building(System(dcfp.Bearing((300.0,), 400.0, 60.0, 1.5e6), ConstantFriction(0.01), NoHeating())), 0.0, "too near to its effective radius"),
        (building(), 1.5, "all bearings lift off at once"),
        (building(), None, "has no vertical component"),
        (building(storeys=(Storey(MASS / 4),), modes=ModeShapes(np.array([0.5]), np.ones((1, 1, 3)))), 0.0, "give the stiffnesses of the storeys"),
    ],
)  # fmt: skip
def test_what_cannot_be_exported_gets_one_sentence(plan, vertical, words) -> None:
    with pytest.raises(InputError, match=words) as caught:
        plan_script(plan, station(vertical or 0.0).scaled(4.0), vertical=vertical != 0.0, tail=0.0)
    assert str(caught.value).count("\n") == 0


def test_names_cannot_leave_their_comments() -> None:
    evil = '"""\nimport os\r\nos.abort()\x00\x0c # \u2028raise SystemExit'
    named = System(replace(LI_2020, name=evil), ConstantFriction(), NoHeating())
    script = plan_script(building(named, name=evil), replace(station(), name=evil), tail=0.0)
    plain = plan_script(building(), station(), tail=0.0)
    assert [type(node) for node in ast.parse(script).body] == [type(node) for node in ast.parse(plain).body]
    assert all(line.startswith("#") for line in script[: script.index("import csv")].splitlines() if line)
    code = script[script.index("import csv") :].splitlines()
    assert max(len(line) for line in code if not line.startswith(("    (", "CORNERS"))) <= 160
