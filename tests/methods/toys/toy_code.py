"""A code from outside of the package: the bearing moves a tenth of the spectral displacement at the period of the pendulum."""

from collections.abc import Sequence

from dcfp.methods.code import CodeInputs, CodeMethod, CodeResult
from dcfp.methods.method import Look
from dcfp.methods.spectra.elastic import displacement
from dcfp.schema.check import Check, at_most
from dcfp.schema.formulas import Formula, number

NAME = "Toy code 2030"
PART = 0.1
LONGEST = 10.0


def calculate(inputs: CodeInputs) -> CodeResult:
    pendulum = inputs.pendulum
    found = PART * float(displacement(inputs.spectrum, pendulum.free_period))
    period = Check(
        "period of the toy", at_most(pendulum.free_period, LONGEST), f"{pendulum.free_period:.2f} s", "at most 10 s", "toy, 1.2", confirmed=False
    )  # fmt: skip
    return CodeResult(NAME, found, pendulum.force(found), pendulum.free_period, conditions=(period,))


def remarks(results: Sequence[CodeResult], inputs: CodeInputs) -> tuple[str, ...]:
    return (f"The toy code was asked at mu {inputs.pendulum.friction:.3f}.",)


def formulas(result: CodeResult, inputs: CodeInputs) -> tuple[Formula, ...]:
    whole = number(result.displacement / PART, 1)
    return (Formula("Toy displacement of the code", "D = S_d / 10", f"{whole} / 10", result.displacement, 1, "mm", "toy, 1.1"),)  # fmt: skip


TOY_CODE = CodeMethod(
    key="toy-code",
    name=NAME,
    citations=("li_2020",),
    look=Look("8", "#117733", 1.3),
    calculate=calculate,
    remarks=remarks,
    formulas=formulas,
)
