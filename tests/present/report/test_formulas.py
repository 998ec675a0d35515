"""Formulas: their numbers give their results, and both forms show the same mathematics."""

import math
import re
from dataclasses import replace
from xml.etree import ElementTree

import pytest

import dcfp
from dcfp.present.report.maths import mathml
from dcfp.present.report.worked import worked_out
from dcfp.study.scenario import Calculation, Scenario
from dcfp.system import FittedFriction, FrictionLaw, friction_law

_FUNCTIONS = {"exp": math.exp, "max": max}


def evaluate(source: str) -> float:
    """Return the value of a source without unknowns, from its MathML: products are written side by side or with a cross."""
    (row,) = ElementTree.fromstring(re.sub(r' xmlns="[^"]*"', "", mathml(source)))
    return _sum(list(row))


def _sum(items: list[ElementTree.Element]) -> float:
    total, sign, factors = 0.0, 1.0, []
    for item in [*items, ElementTree.fromstring("<mo>+</mo>")]:
        if item.tag == "mo" and item.text in ("+", "−"):
            if factors:
                total += sign * math.prod(_factors(factors))
                sign, factors = 1.0, []
            sign *= 1.0 if item.text == "+" else -1.0
        else:
            factors.append(item)
    return total


def _factors(items: list[ElementTree.Element]) -> list[float]:
    found: list[float] = []
    place = 0
    while place < len(items):
        item = items[place]
        place += 1
        if item.tag == "mtext":
            inside = items[place]
            assert inside.tag == "mrow"
            place += 1
            found.append(_FUNCTIONS[item.text](*_arguments(inside)))
        elif item.tag != "mspace" and (item.tag, item.text) != ("mo", "×"):
            found.append(_value(item))
    return found


def _arguments(row: ElementTree.Element) -> list[float]:
    parts: list[list[ElementTree.Element]] = [[]]
    for item in _inside(row):
        if (item.tag, item.text) == ("mo", ","):
            parts.append([])
        else:
            parts[-1].append(item)
    return [_sum(part) for part in parts]


def _inside(row: ElementTree.Element) -> list[ElementTree.Element]:
    """Return the items of a row without the parentheses in which it stands."""
    return [item for item in row if (item.tag, item.text) not in (("mo", "("), ("mo", ")"))]


def _value(node: ElementTree.Element) -> float:
    parts = list(node)
    match node.tag, node.text:
        case "mn", str(text):
            return float(text)
        case "mi", "π":
            return math.pi
        case "mrow", _:
            return _sum(_inside(node))
        case "mfrac", _:
            return _value(parts[0]) / _value(parts[1])
        case "msqrt", _:
            return math.sqrt(_value(parts[0]))
        case "msup", _:
            return _value(parts[0]) ** _value(parts[1])
        case found:
            msg = f"{found} has no value"
            raise ValueError(msg)


def agrees(formula) -> bool:
    found = evaluate(formula.numbers)
    # printed numbers have four digits or more, and differences of them lose some
    return found == pytest.approx(formula.value, rel=1.5e-3, abs=1.01 * 10.0**-formula.decimals)


def worked(model: dcfp.Bearing | None = None, **changes) -> Calculation:
    from dcfp.study import Study
    from dcfp.study.scenario import calculate
    from dcfp.system import System

    motion = dcfp.load_motion(changes.pop("record", "NCC")).scaled_to_pgv(changes.pop("pgv", 500.0))
    chosen = replace(System(), **({} if model is None else {"bearing": model}), **changes)
    return calculate(Scenario(Study([motion], model=chosen)))


def test_the_numbers_of_every_formula_give_its_result(calculation: Calculation) -> None:
    formulas = worked_out(calculation)[1]
    assert len(formulas) > 60
    with_numbers = [one for one in formulas if one.numbers]
    assert len(with_numbers) > 50
    wrong = [(one.name, one.numbers, one.value) for one in with_numbers if not agrees(one)]
    assert wrong == []


@pytest.mark.parametrize(
    "made",
    [
        # an amplified pulse; a soft pulse that moves nothing; a single plate with another law; no heating
        {"record": "LPG", "pgv": 250.0},
        {"record": "NCC", "pgv": 40.0},
        {"model": dcfp.Bearing((3000.0,), 300.0, 50.0, 1.9e6), "friction": dcfp.Kumar2015(0.06, 50.0), "record": "IVD", "pgv": 1000.0},
        {"heating": dcfp.NoHeating(), "friction": dcfp.ConstantFriction(0.12)},
    ],
)  # fmt: skip
def test_so_they_do_of_other_bearings_and_records(made) -> None:
    formulas = worked_out(worked(**made))[1]
    assert [(one.name, one.numbers, one.value) for one in formulas if one.numbers and not agrees(one)] == []


def test_what_makes_a_method_unreliable_stands_below_its_formulas() -> None:
    section = worked_out(worked(record="LPG", pgv=250.0))[0]
    (pulse,) = [one for one in section.parts if one.title == "Prediction by the pulse method"]
    assert str(pulse.blocks[-1]).count("LPG: dy by the pulse method is unreliable, since") == 2


@pytest.mark.parametrize("name", sorted(dcfp.system.FRICTION_LAWS))
def test_every_law_has_equations_and_its_own_coefficient(name: str) -> None:
    law: FrictionLaw = FittedFriction(pressure_floor=0.1) if name == "fitted" else friction_law(name)
    assert law.equations()
    assert all(mathml(equation) for equation in law.equations())
    formulas = law.formulas(50.0, 123.4, 67.8, "source")
    if name == "lomiento2013":  # it wears off: no single state has a coefficient
        assert formulas == ()
        return
    assert formulas[-1].value == float(law.coefficient(50.0, 123.4, 67.8))
    assert all(agrees(one) for one in formulas if one.numbers)


def test_every_formula_is_mathematics_for_a_browser(calculation: Calculation) -> None:
    for formula in worked_out(calculation)[1]:
        for line in formula.lines:
            tree = ElementTree.fromstring(mathml(line))
            numbers = " ".join(tree.itertext())
            assert set(re.findall(r"\d+\.\d+", line)) <= set(re.findall(r"\d+\.\d+", numbers))


def test_fractions_and_scripts_take_parentheses_away() -> None:
    assert "<mfrac><mrow><mi>a</mi><mo>+</mo><mi>b</mi></mrow><mi>c</mi></mfrac>" in mathml("(a + b) / c")
    assert "<msub><mi>k</mi><mtext>ra</mtext></msub>" in mathml('k_"ra"')
    assert "<mo>(</mo>" in mathml("2 (a + b)")
    assert mathml('"<b>"').count("&lt;b&gt;") == 1


@pytest.mark.parametrize("wrong", ["(a + b", "a + b)  )", "velocity", "a_"])
def test_what_is_no_mathematics_is_refused(wrong: str) -> None:
    if wrong == "a + b)  )":
        assert mathml(wrong)  # a lone parenthesis is a sign
        return
    with pytest.raises(ValueError, match=r"mathematics|symbol"):
        mathml(wrong)
