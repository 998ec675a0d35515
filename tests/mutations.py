"""Mutations that the tests must kill: each is one small error in the source, and the tests that are expected to see it.

python tests/mutations.py [NAME...]

copies the repository into a temporary folder, makes one error at a time, and says whether the tests failed. The exit status is 1 if one
survives. The tests run one after the other in one process, and kernels are compiled into a folder of their own.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[1]
#: What the tests do not need, or make themselves.
_LEFT_OUT = shutil.ignore_patterns(
    ".git", ".venv", ".ci", "_build", "__pycache__", ".*_cache", "node_modules"
)
#: Longest time that the tests of a mutation may take [s]; one that never comes to an end is killed.
_PATIENCE = 900.0


@dataclass(frozen=True)
class Mutation:
    """One error.

    Attributes
    ----------
    name
        What is wrong, in words.
    file
        In ``src/dcfp``.
    old, new
        Text that must be found there once, and what stands in its place.
    tests
        Files or tests below ``tests`` that must fail.
    """

    name: str
    file: str
    old: str
    new: str
    tests: tuple[str, ...]

    def applied(self, source: str) -> str:
        """Return the source with the error in it; fail if its place is not found once."""
        found = source.count(self.old)
        if found != 1:
            msg = f"{self.name}: {self.old!r} is found {found} times in {self.file}, not once"
            raise ValueError(msg)
        return source.replace(self.old, self.new)


MUTATIONS = (
    # kernels
    Mutation(
        "friction in the middle of a slide",
        "kernels/sliding.py",
        "slope = (last - friction + 4.0 * bend) * per_length",
        "slope = (last - friction + 3.9 * bend) * per_length",
        ("kernels/test_sliding.py",),
    ),
    Mutation(
        "centre of a plate without its share of the travel",
        "kernels/heating.py",
        "abs(portion * displacement) <= heat.half_contact",
        "abs(displacement) <= heat.half_contact",
        ("kernels/test_point_heating.py",),
    ),
    Mutation(
        "weight of a mode of a finite plate",
        "kernels/sum_of_exponentials.py",
        "(0.56421, 1.12054, ",
        "(0.56421, 1.13054, ",
        ("kernels/test_finite_plate.py",),
    ),
    Mutation(
        "a short record keeps the end of a longer one in a batch",
        "kernels/integrate.py",
        "for i in range(samples, filled):",
        "for i in range(filled, samples):",
        ("analysis/test_batch.py",),
    ),
    # formulas
    Mutation(
        "energy of the ground's own motion",
        "analysis/response.py",
        "(0.5 * ground + velocity)",
        "(ground + velocity)",
        ("analysis/test_respond.py",),
    ),
    Mutation(
        "displacement by a pulse",
        "methods/li_2020/pulse_method.py",
        "(2.0 * k_g**2 * (k_u - k_next))",
        "(2.0 * k_g * k_u * (k_u - k_next))",
        ("methods/test_pulse_method.py",),
    ),
    Mutation(
        "residual displacements that add up",
        "methods/eurocode_8.py",
        "1.35 * (1.0 - (d_y / d_cd) ** 0.6)",
        "1.30 * (1.0 - (d_y / d_cd) ** 0.6)",
        ("methods/test_eurocode_8.py",),
    ),
    Mutation(
        "rank of a quantile",
        "inference/statistics.py",
        "part * (ordered.size + 1)",
        "part * ordered.size",
        ("inference/test_intervals.py",),
    ),
    # limits
    Mutation(
        "a slider of half a millimetre",
        "system/bearing.py",
        '"diameter of the slider", MM, 10.0,',
        '"diameter of the slider", MM, 0.1,',
        ("system/test_bearing.py",),
    ),
    Mutation(
        "at the capacity is beyond it, in a batch",
        "analysis/batch.py",
        'extremes["displacement"] > capacity',
        'extremes["displacement"] >= capacity',
        ("analysis/test_batch.py",),
    ),
    Mutation(
        "at the capacity is beyond it, in a fragility",
        "study/assessment/fragility_fit.py",
        "row[known] > capacity",
        "row[known] >= capacity",
        ("study/assessment/test_study_fragility.py",),
    ),
    # units
    Mutation(
        "size of a kip",
        "schema/units.py",
        "4448.2216152605",
        "4448.0",
        ("schema/test_units.py",),
    ),
    Mutation(
        "the unit of a text in a file is not read",
        "schema/parameters.py",
        "return convert(number, named, self.unit, label, difference=self.difference)",
        "return number",
        ("system/test_bearing.py",),
    ),
    Mutation(
        "scale of a K-NET file",
        "motion/formats/kyoshin.py",
        "return top / bottom",
        "return 1.0 / bottom",
        ("motion/test_record_formats.py",),
    ),
    # doors
    Mutation(
        "digits of a CSV file",
        "schema/table.py",
        "{value:.9g}",
        "{value:.5g}",
        ("schema/test_table.py",),
    ),
    Mutation(
        "key of the residual displacement",
        "analysis/response.py",
        '"residual_displacement", "residual_mm"',
        '"residual_displacement", "residual_cm"',
        ("doors/cli/test_respond.py",),
    ),
    Mutation(
        "origin of a page by its host alone",
        "doors/app/serve.py",
        "_place(origin) == own",
        '(_place(origin) or ("", ""))[1] == own[1]',
        ("doors/app/test_speed_and_safety.py::test_another_host_or_origin_is_refused",),
    ),
    Mutation(
        "a number of the report",
        "present/report/worked.py",
        "math.sqrt(bearing.mass / bearing.restoring_stiffness)",
        "math.sqrt(bearing.mass / bearing.elastic_stiffness)",
        ("present/report/test_formulas.py",),
    ),
    # stores
    Mutation(
        "half a block is a whole one",
        "study/store.py",
        "bool((status != NOT_RUN).all())",
        "bool((status != NOT_RUN).any())",
        ("study/test_resume.py",),
    ),
    Mutation(
        "an incomplete last block",
        "study/study.py",
        "min(a + c, n) for a, c, n",
        "a + c for a, c, n",
        ("study/test_plan.py",),
    ),
)


def main(names: list[str]) -> int:
    """Try the mutations whose names begin so, or all; return how many survive, at most 1."""
    chosen = [one for one in MUTATIONS if not names or one.name.startswith(tuple(names))]
    survivors: list[str] = []
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "dcfp"
        shutil.copytree(ROOT, copy, ignore=_LEFT_OUT)
        for one in chosen:
            killed = is_killed(one, copy, Path(folder) / "kernels")
            print(f"{'killed' if killed else 'SURVIVED'}: {one.name}", flush=True)
            if not killed:
                survivors.append(one.name)
    print(f"{len(chosen) - len(survivors)} of {len(chosen)} killed")
    return min(len(survivors), 1)


def is_killed(mutation: Mutation, copy: Path, cache: Path) -> bool:
    """Whether the tests fail with the error in a copy of the repository, which is taken out again."""
    place = copy / "src" / "dcfp" / mutation.file
    source = place.read_text(encoding="utf-8")
    place.write_text(mutation.applied(source), encoding="utf-8")
    environment = {
        **os.environ,
        "PYTHONPATH": str(copy / "src"),
        "PYTHONDONTWRITEBYTECODE": "1",  # Python tells an edited source by its second and size
        "DCFP_CACHE_DIR": str(cache),
    }
    tests = [f"tests/{name}" for name in mutation.tests]
    command = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", "--slow", *tests]
    try:
        done = subprocess.run(
            command, cwd=copy, env=environment, timeout=_PATIENCE, capture_output=True, text=True
        )
        status = done.returncode
    except subprocess.TimeoutExpired:
        return True
    finally:
        place.write_text(source, encoding="utf-8")
    if status not in (0, 1):  # neither passed nor failed: there are no such tests, or they cannot be run
        msg = f"{mutation.name}: the tests could not be run\n{done.stdout}{done.stderr}"
        raise RuntimeError(msg)
    return status == 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
