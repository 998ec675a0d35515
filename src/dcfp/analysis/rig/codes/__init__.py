"""Prototype tests that codes ask for, by name, and what the codes want of their results."""

from collections.abc import Callable, Sequence

from dcfp.analysis.rig.codes import asce_2016, en_15129, ntc_2018
from dcfp.analysis.rig.codes.prototype import CRITERIA as CRITERIA
from dcfp.analysis.rig.codes.prototype import PropertyFactor as PropertyFactor
from dcfp.analysis.rig.codes.prototype import PrototypeDesign as PrototypeDesign
from dcfp.analysis.rig.codes.prototype import property_factors as property_factors
from dcfp.analysis.rig.loops import Loops
from dcfp.analysis.rig.program import Program
from dcfp.errors import InputError
from dcfp.schema.check import Check

_PROGRAMS: dict[str, Callable[[PrototypeDesign], Program]] = {
    "asce7-16": asce_2016.prototype_program,
    "en15129": en_15129.prototype_program,
}
_JUDGES: dict[str, Callable[[Sequence[Loops]], list[Check]]] = {
    "asce7-16": asce_2016.judge,
    "en15129": en_15129.judge,
}


def prototype_programs() -> tuple[str, ...]:
    """Return the names of the codes whose prototype tests can be made."""
    return tuple(_PROGRAMS)


def prototype_program(code: str, design: PrototypeDesign) -> Program:
    """Return the prototype tests of a code for a design.

    Raises
    ------
    InputError
        If there is no such code.
    """
    if code not in _PROGRAMS:
        msg = f"There are no prototype tests of {code!r}; the choices are {', '.join(_PROGRAMS)}."
        raise InputError(msg)
    return _PROGRAMS[code](design)


def judge_tests(program: Program, loops: Sequence[Loops]) -> list[Check]:
    """Return what the code of a program wants of its tests, and NTC 2018 of those at the maximum displacement and for endurance; nothing for a program of no code."""
    if program.code not in _JUDGES:
        return []
    return [*_JUDGES[program.code](loops), *ntc_2018.judge(loops)]
