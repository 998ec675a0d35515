"""What a report rests on: its cases and their checks, its sources, the versions of the programs; and every number of it, ready for JSON."""

import platform
from dataclasses import asdict, replace
from importlib import metadata
from typing import Any

from dcfp.inference.told import case_objects
from dcfp.kernels._jit import source_digest
from dcfp.methods.code import code_methods
from dcfp.present.report.document import DECIMALS, written
from dcfp.schema.check import COLUMNS, Check
from dcfp.schema.citations import bibliography, citation
from dcfp.schema.formulas import Formula
from dcfp.schema.units import KN_M, M_PER_S2
from dcfp.study.scenario import Calculation, ScenarioResult
from dcfp.version import version

ANALYSIS = "analysis"
#: What the checks of every analysis cite.
_OF_CHECKS = ("fema_p695_2009",)


def label_of(result: ScenarioResult) -> str:
    """Return the name of a case: the record and the PGV."""
    return f"{result.motion.name}, {written('pgv_m_s', result.motion.peak_velocity / 1e3)} m/s"


def checks_of(result: ScenarioResult) -> tuple[Check, ...]:
    """Return every check of a case: those of the analysis, then the conditions of each code."""
    of_analysis = [replace(one, of=ANALYSIS) for one in result.response.checks]
    of_codes = [replace(one, of=name) for name, said in result.case.codes.items() for one in said.conditions]
    return (*of_analysis, *of_codes)


def sources_of(calculation: Calculation) -> tuple[str, ...]:
    """Return the references that a report cites, each as a line."""
    used = {name for one in calculation.results for name in one.case.codes}
    codes = [key for name, method in code_methods().items() if name in used for key in method.citations]
    law = calculation.scenario.model.friction.citation
    keys = dict.fromkeys(("li_2020", law, *codes, *_OF_CHECKS))
    return tuple(full_citation(key) for key in keys if key)


def full_citation(key: str) -> str:
    """Return a reference as a line with its volume, number and pages, as far as the bibliography has them."""
    entry = bibliography()[key]
    number = f"({entry['number']})" if "number" in entry else ""
    places = [f"{entry['volume']}{number}"] if "volume" in entry else []
    places += [entry["pages"].replace("--", "–")] if "pages" in entry else []
    before, mark, doi = citation(key).partition(" doi:")
    return f"{', '.join((before.removesuffix('.'), *places))}.{mark}{doi}"


def record_citations(calculation: Calculation) -> tuple[str, ...]:
    """Return how the data of the records ask to be cited, each once."""
    asked = (motion.origin.citation for motion in calculation.scenario.study.motions)
    return tuple(dict.fromkeys(words for words in asked if words))


def source_of(key: str) -> str:
    """Return authors and year of an entry of the bibliography, as they stand beside a formula."""
    if key not in bibliography():
        return "law of the scenario"
    entry = bibliography()[key]
    authors = [name.split(",")[0].strip() for name in entry["author"].split(" and ")]
    who = f"{authors[0]} et al." if len(authors) > 2 else " and ".join(authors)
    return f"{who} ({entry['year']})"


# Versions of what makes the numbers and the pages, besides this package.


#: Packages by their names in the report; Typst is there only where a PDF can be made.
_PACKAGES = {"NumPy": "numpy", "SciPy": "scipy", "Numba": "numba", "Typst (of the PDF)": "typst"}


def versions() -> dict[str, str]:
    """Return the versions of Python and of the packages that are installed, by their names."""
    found = {"Python": platform.python_version()}
    for name, package in _PACKAGES.items():
        try:
            found[name] = metadata.version(package)
        except metadata.PackageNotFoundError:  # a page is made without it
            continue
    return found


# Every number of a report, ready for JSON.


def numbers_of(calculation: Calculation, formulas: tuple[Formula, ...]) -> dict[str, Any]:
    """Return the numbers of a report.

    Parameters
    ----------
    calculation
        The results; ``cases`` has an object for each, with the keys of ``dcfp respond --json`` and of ``dcfp compare --json``.
    formulas
        Those that are worked out in the report.
    """
    scenario = calculation.scenario
    model = scenario.model
    digests = {motion.name: motion.digest for motion in scenario.study.motions}
    compared = case_objects([one.case for one in calculation.results], calculation.methods)
    return {
        "title": scenario.title,
        "report": asdict(scenario.heading),
        "version": version(),
        "kernels_sha256": source_digest(),
        "versions": versions(),
        "decimals": DECIMALS,
        "bearing": asdict(model.bearing)
        | {
            "vertical_force_N": model.bearing.vertical_force,
            "mass_t": model.bearing.mass,
            "restoring_stiffness_N_mm": model.bearing.restoring_stiffness,
            "period_s": model.bearing.period,
        },
        "friction_law": repr(model.friction),
        "heating_model": repr(model.heating),
        "settings": asdict(scenario.study.settings),
        "nominal_friction": calculation.nominal.value,
        "nominal_friction_source": calculation.nominal.source,
        "cases": [
            _case(one, row, found) | {"record_sha256": digests[one.motion.name]}
            for one, row, found in zip(calculation.results, calculation.summary, compared, strict=True)
        ],
        "formulas": [one.as_numbers() for one in formulas],
        "references": list(sources_of(calculation)),
    }


def energies_of(result: ScenarioResult) -> dict[str, float]:
    """Return the energies at the end of an analysis [kN m], and the residual of their balance over the largest input [-]."""
    energy = result.response.energy
    ends = {
        "input": energy.input,
        "hysteretic": energy.hysteretic,
        "strain": energy.strain,
        "kinetic": energy.kinetic,
        "absolute_input": energy.absolute_input,
        "residual": energy.residual,
    }
    return {f"{name}_kN_m": KN_M.shown(float(values[-1])) for name, values in ends.items()} | {
        "largest_residual_over_largest_input": energy.relative_residual
    }


def _case(one: ScenarioResult, row: dict[str, Any], compared: dict[str, Any]) -> dict[str, Any]:
    motion = one.motion
    return {
        **compared,
        **row,
        "remarks": one.response.all_remarks,
        "pga_m_s2": M_PER_S2.shown(motion.peak_acceleration),
        "scaled_record_sha256": motion.digest,
        "record_origin": asdict(motion.origin),
        "record_treatment": list(motion.treatment),
        "energies": energies_of(one),
        "checks": [
            {"of": check.of, **{one.key: one.datum(check) for one in COLUMNS if one.stored}}
            for check in checks_of(one)
        ],
    }
