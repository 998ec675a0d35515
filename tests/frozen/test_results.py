"""What the command line answers is what it answered before; a number that moves on purpose is named in the changelog, and frozen anew."""

import pytest

from .commands import QUICK, command_lines
from .results import Difference, answers_to, differences, entry_point, load

#: Machines differ in the last digits of an exponential; results.py compares without it [-].
TOLERANCE = 1e-9


@pytest.mark.slow
def test_the_quick_commands_answer_as_before() -> None:
    frozen = load()
    found = [
        f"{line}: {one}"
        for line, answer, _ in answers_to(command_lines(QUICK), entry_point())
        for one in differences(frozen[line], answer)
        if not one.within(TOLERANCE) and not one.is_wording
    ]
    assert found == []


@pytest.mark.parametrize(
    ("before", "after", "path"),
    [
        ({"a": [1.0, 2.0]}, {"a": [1.0, 2.0000000001]}, "a[1]"),
        ({"a": [1.0]}, {"a": [1.0, 2.0]}, "a.length"),
        ({"a": {"b": True}}, {"a": {}}, "a.b"),
        ({"verdict": "met"}, {"verdict": "not met"}, "verdict"),
        ({"energy_residual": 1e-15}, {"energy_residual": 1e-3}, "energy_residual"),
    ],
)
def test_a_change_is_named(before: dict, after: dict, path: str) -> None:
    assert [one.path for one in differences(before, after)] == [path]


def test_times_and_rounding_and_new_keys_are_no_changes() -> None:
    before = {"elapsed_s": 1.0, "energy_residual": 1e-15, "y_mm": float("nan")}
    after = {"elapsed_s": 2.0, "energy_residual": -2e-15, "y_mm": float("nan"), "new": 1}
    assert list(differences(before, after)) == []
    assert Difference("remark", "It never slides.", "It does not slide.").is_wording
