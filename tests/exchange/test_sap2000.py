"""Link properties for SAP2000 and ETABS: the friction is the law's, the linear properties are those of the loop, and the tables are read back."""

import re
from dataclasses import replace

import numpy as np
import pytest

import dcfp
from dcfp import LI_2020, Bearing, ConstantFriction, Kumar2015, Li2020, NoHeating, SimplifiedHeating, System
from dcfp.errors import InputError
from dcfp.exchange import link_table, sap2000_text
from dcfp.exchange.sap2000 import link_properties
from dcfp.system.friction import FrictionLaw
from dcfp.system.plan import EQUAL, Plan, grid

HEATED = System(LI_2020, Li2020(), SimplifiedHeating())
UNEQUAL = System(
    Bearing((3000.0, 2000.0), 350.0, 45.0, 1.2e6, name="unequal"), Kumar2015(), SimplifiedHeating()
)
SINGLE = System(Bearing((2500.0,), 350.0, 45.0, 1.2e6, name="single"), ConstantFriction(0.06), NoHeating())
SIX = grid([0.0, 6000.0, 12000.0], [0.0, 8000.0])


def plan(types=HEATED, **more) -> Plan:
    return Plan(SIX, types, **more)


def tables_of(text: str) -> dict[str, list[dict[str, str]]]:
    """Return the rows of each table, as the program reads them: fields apart by three spaces, texts with a space in quotes."""
    found: dict[str, list[dict[str, str]]] = {}
    rows: list[dict[str, str]] = []
    for line in text.splitlines():
        if name := re.fullmatch(r'TABLE:  "(.+)"', line):
            rows = found.setdefault(name[1], [])
        elif line.startswith("   "):
            rows.append({key: value.strip('"') for key, value in re.findall(r'(\w+)=("[^"]*"|\S+)', line)})
    return found


def test_an_exponential_law_is_met_exactly() -> None:
    (link,) = link_properties(plan(), temperature=80.0)
    law, pressure = Li2020(), plan().static_loads.mean() / LI_2020.slider_area
    assert link.fast == pytest.approx(float(law.coefficient(pressure, 1e9, 80.0)))
    assert link.slow == pytest.approx(float(law.coefficient(pressure, 0.0, 80.0)))
    assert link.misfit < 1e-9
    speeds = np.linspace(0.0, 1000.0, 40)
    of_link = link.fast - (link.fast - link.slow) * np.exp(-link.rate * speeds)
    np.testing.assert_allclose(of_link, law.coefficient(pressure, speeds, 80.0), rtol=1e-7)


def test_the_speed_on_one_plate_is_half_of_that_of_the_link() -> None:
    (link,) = link_properties(plan(System(LI_2020, Kumar2015(), NoHeating())))
    assert link.rate == pytest.approx(0.05)  # half of the law's 0.1
    (one,) = link_properties(plan(System(SINGLE.bearing, Kumar2015(), NoHeating())))
    assert one.rate == pytest.approx(0.1)


def test_plates_that_differ_are_met_nearly_and_it_is_said_how() -> None:
    (link,) = link_properties(plan(UNEQUAL))
    speeds = np.linspace(0.0, 1000.0, 2001)
    pressure = link.pressure
    law = 0.6 * Kumar2015().coefficient(pressure, 0.6 * speeds, 20.0) + 0.4 * Kumar2015().coefficient(
        pressure, 0.4 * speeds, 20.0
    )
    found = link.fast - (link.fast - link.slow) * np.exp(-link.rate * speeds)
    assert 1e-5 < link.misfit < 1e-3
    assert np.abs(found - law).max() == pytest.approx(link.misfit, rel=0.02)
    assert f"the largest difference to the law from 0 to 1 m/s is {link.misfit:.2g}" in plain(
        sap2000_text(plan(UNEQUAL))
    )


class Bent(FrictionLaw):
    """A law that rises and falls with the speed."""

    name = "bent"

    def at_pressure(self, pressure: float) -> dcfp.kernels.law.Law:
        raise NotImplementedError

    def coefficient(self, pressure, speed, temperature, dose=0.0):
        v = np.asarray(speed) / 1000.0
        return 0.05 + 0.04 * v / (0.05 + v) - 0.01 * v


def test_another_law_is_met_as_nearly_as_can_be() -> None:
    system = System(LI_2020, Bent(), NoHeating())
    (link,) = link_properties(plan(system))
    speeds = np.linspace(0.0, 1000.0, 501)
    law = Bent().coefficient(0.0, speeds, 0.0)

    def squares(slow: float, fast: float, rate: float) -> float:
        return float(((fast - (fast - slow) * np.exp(-rate * speeds) - law) ** 2).sum())

    best = squares(link.slow, link.fast, link.rate)
    for change in (0.98, 1.02):
        assert best < squares(change * link.slow, link.fast, link.rate)
        assert best < squares(link.slow, change * link.fast, link.rate)
        assert best < squares(link.slow, link.fast, change * link.rate)
    assert link.misfit > 1e-3


def test_the_linear_properties_are_those_of_the_loop() -> None:
    displacement = 180.0
    (link,) = link_properties(plan(SINGLE), displacement=displacement)
    load, mu, radius = link.load, 0.06, 2500.0
    largest = mu * load + load / radius * displacement
    assert link.effective_stiffness == pytest.approx(largest / displacement)
    dissipated, stored = 4.0 * mu * load * displacement, 0.5 * largest * displacement
    assert link.damping_ratio == pytest.approx(dissipated / (4.0 * np.pi * stored))
    # a dashpot at the link's own frequency dissipates the same
    frequency = np.sqrt(link.effective_stiffness / (load / 9806.65))
    assert np.pi * link.effective_damping * frequency * displacement**2 == pytest.approx(dissipated)
    (unknown,) = link_properties(plan(SINGLE))
    assert (unknown.effective_stiffness, unknown.effective_damping) == (pytest.approx(load / radius), 0.0)
    assert unknown.damping_ratio is None


def test_the_tables_are_read_back() -> None:
    building = plan((HEATED, SINGLE, UNEQUAL) * 2, centre=(6500.0, 4200.0))
    text = sap2000_text(building, 60.0, 200.0)
    tables = tables_of(text)
    assert tables["PROGRAM CONTROL"] == [{"ProgramName": "SAP2000", "CurrUnits": "N, mm, C"}]
    general = tables["LINK PROPERTY DEFINITIONS 01 - GENERAL"]
    assert [one["Link"] for one in general] == ["Li et al. (2020)_ phi 400", "single", "unequal"]
    assert {one["LinkType"] for one in general} == {"Friction Isolator"}
    # the moment of the load goes to the slab as far as the slider stays behind it
    assert [float(one["PDM2J"]) for one in general] == [0.5, 0.0, 0.4]
    assert all(float(one["PDM3I"]) + float(one["PDM3J"]) == 1.0 for one in general)
    rows = tables["LINK PROPERTY DEFINITIONS 08 - SLIDING ISOLATOR"]
    assert [one["DOF"] for one in rows] == ["U1", "U2", "U3"] * 3
    for link, place in zip(link_properties(building, 60.0, 200.0), range(0, 9, 3), strict=True):
        for row in rows[place + 1 : place + 3]:
            wanted = {
                "TransKE": link.effective_stiffness, "TransCE": link.effective_damping, "DJ": 0.0, "TransK": link.stiffness,
                "Slow": link.slow, "Fast": link.fast, "Rate": link.rate, "Radius": link.radius,
            }  # fmt: skip
            assert {key: float(row[key]) for key in wanted} == pytest.approx(wanted, rel=1e-8)
    assert text.rstrip().endswith("END TABLE DATA")


def plain(text: str) -> str:
    """Return the head of a text in one line."""
    return " ".join(text[: text.index("TABLE:")].replace("\n$", " ").split())


def test_the_load_is_the_mean_of_the_type_and_what_that_leaves_out_is_said() -> None:
    building = plan(centre=(6800.0, 4300.0))
    (link,) = link_properties(building)
    loads = building.static_loads
    assert link.load == pytest.approx(loads.mean())
    assert link.stiffness == pytest.approx(1.9e6 * loads.mean() / LI_2020.vertical_force)
    head = plain(sap2000_text(building))
    law = Li2020()
    for load in (loads.min(), loads.max()):
        words = f"{float(law.coefficient(load / LI_2020.slider_area, 1000.0, 20.0)):.4f} under {load / 1e3:.0f} kN"
        assert words in head
    assert f"{float(law.coefficient(link.pressure, 1000.0, 70.0)):.4f} at 70 degC" in head
    assert "TransK of Li et al. (2020)_ phi 400 is that of the mean load" in head
    assert "is that of the mean load" not in plain(sap2000_text(replace(building, spring=EQUAL)))
    for words in ("neither heat nor pressure", "sum of their radii", "Unconfirmed", ".e2k"):
        assert words in head
    (constant,) = link_properties(plan(SINGLE))
    assert (constant.slow, constant.fast, constant.rate, constant.misfit) == (0.06, 0.06, 0.0, 0.0)
    assert "The law of single gives" not in plain(sap2000_text(plan(SINGLE)))


def test_the_table_is_told_with_its_units() -> None:
    table = link_table(plan((HEATED, SINGLE) * 3), displacement=150.0)
    first, second = table.objects()
    assert first["bearings"] == second["bearings"] == 3
    assert second["friction_fast"] == 0.06
    assert second["stiffness_kN_mm"] == pytest.approx(
        link_properties(plan((HEATED, SINGLE) * 3))[1].stiffness / 1e3
    )
    assert "effective_damping_kN_s_mm [kN s mm-1]" in table.csv().splitlines()[0]
    assert len({len(row) for row in (table.heads(), *table.cells())}) == 1


def test_names_cannot_leave_their_fields() -> None:
    evil = 'a" \nTABLE:  "X"\r Link=b\u2028'
    types = tuple(
        System(replace(LI_2020, name=evil, pressure=40.0 + i), ConstantFriction(), NoHeating())
        for i in range(6)
    )
    text = sap2000_text(plan(types, name=evil))
    tables = tables_of(text)
    assert list(tables) == [
        "PROGRAM CONTROL",
        "LINK PROPERTY DEFINITIONS 01 - GENERAL",
        "LINK PROPERTY DEFINITIONS 08 - SLIDING ISOLATOR",
    ]
    assert len({one["Link"] for one in tables["LINK PROPERTY DEFINITIONS 01 - GENERAL"]}) == 6
    head = text[: text.index("\n\nTABLE:")].splitlines()
    assert all(line.startswith("$ ") for line in head)
    assert max(map(len, head)) <= 115


@pytest.mark.parametrize(
    ("changes", "words"), [({"temperature": 5000.0}, "temperature"), ({"displacement": 0.0}, "displacement")]
)
def test_what_is_out_of_range_gets_one_sentence(changes, words) -> None:
    with pytest.raises(InputError, match=words) as caught:
        sap2000_text(plan(), **changes)
    assert str(caught.value).count("\n") == 0
