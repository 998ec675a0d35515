"""Half cycles of a response: Eqs (15) and (16) of Li et al. (2020)."""

import numpy as np
import pytest

from dcfp import NoHeating, load_motion, respond
from dcfp.analysis.half_cycles import half_cycle_table, half_cycles


@pytest.fixture(scope="module")
def response():
    return respond(load_motion("NCC").scaled_to_pgv(500.0), heating=NoHeating())


def test_what_is_put_in_and_not_dissipated_is_in_the_springs(response) -> None:
    """Eq. (15): dEr = dEhr + dEs where the kinetic energy is zero."""
    stiffness, bearing = response.bearing.restoring_stiffness, response.bearing
    # spring (b) stores at most this
    small = 0.5 * (0.075 * bearing.vertical_force) ** 2 / bearing.elastic_stiffness
    found = half_cycles(response, 5.0)
    assert len(found) > 10
    for one in found:
        stored = 0.5 * stiffness * (one.to_displacement**2 - one.from_displacement**2)
        assert one.net_input - one.hysteretic == pytest.approx(stored, abs=2.0 * small)
        assert one.most_input >= one.net_input


def test_they_follow_each_other_and_add_up(response) -> None:
    found = half_cycles(response)
    assert [one.to_displacement for one in found[:-1]] == [one.from_displacement for one in found[1:]]
    at = np.searchsorted(response.time, found[-1].swing.end)
    assert sum(one.hysteretic for one in found) == pytest.approx(response.energy.hysteretic[at], rel=1e-3)


def test_only_those_asked_for_are_told(response) -> None:
    rows = half_cycle_table([response], 50.0).objects()
    assert 0 < len(rows) < len(half_cycles(response, 20.0))
    assert min(abs(row["dy_mm"]) for row in rows) >= 50.0
    mass = response.bearing.mass
    for row in rows:
        assert row["V_dEhr_mm_s"] == pytest.approx((2.0 * row["dEhr_N_mm"] / mass) ** 0.5)


def test_both_sides_of_eq_15_are_equal() -> None:
    """Input from the ground on one side, friction and springs on the other; the ends lie between samples, which leaves up to mu N r_f."""
    for name in ("NCC", "LPG"):
        response = respond(load_motion(name).scaled_to_pgv(1000.0))
        found = half_cycles(response)
        most = max(one.net_input for one in found)
        assert max(abs(one.net_input - one.hysteretic - one.strain) for one in found) < 2e-3 * most
        assert any(abs(one.strain) > 0.2 * one.hysteretic for one in half_cycles(response, 50.0))
