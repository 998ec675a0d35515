"""Type tests of curved surface sliders: after EN 15129, section 8.3.4.

*Unconfirmed* as a whole: the standard's text could not be read. Names, speeds and limits are from memory of it, and stand below as constants.
"""

import math
from collections.abc import Sequence

import numpy as np

from dcfp.analysis.rig.codes.prototype import PrototypeDesign, criterion
from dcfp.analysis.rig.loops import Loops
from dcfp.analysis.rig.program import Program, RigTest
from dcfp.analysis.rig.waveform import Sine
from dcfp.schema.check import Check

CODE = "EN 15129"
#: Peak velocity of the benchmark tests [mm/s], unconfirmed.
BENCHMARK_VELOCITY = 50.0
#: Displacements over d_bd of the dynamic tests, unconfirmed.
DYNAMIC = {"D1": 0.25, "D2": 0.5, "D3": 1.0}
CYCLES = 3
#: How far stiffness and energy may be from the design values [-], unconfirmed.
LARGEST_DEVIATION = 0.15


def prototype_program(design: PrototypeDesign) -> Program:
    """Return benchmark, dynamic, and seismic tests under the largest and smallest load, and the benchmark again; three cycles each.

    Every test starts on cold plates.
    """
    d = design.displacement
    peak = 2.0 * math.pi * d / design.period
    benchmark = Sine(d, BENCHMARK_VELOCITY, CYCLES)
    tests = [
        RigTest("P1", benchmark, design.load(), purpose="benchmark", role="increment"),
        *(
            RigTest(
                name,
                Sine(part * d, peak, CYCLES),
                design.load(),
                purpose=f"dynamic, {part:g} d_bd",
                role="maximum" if part == 1.0 else "increment",
            )
            for name, part in DYNAMIC.items()
        ),
        RigTest(
            "E1",
            Sine(d, peak, CYCLES),
            design.load(design.largest_load),
            purpose="seismic, largest load",
            role="stability",
        ),
        RigTest(
            "E2",
            Sine(d, peak, CYCLES),
            design.load(design.least_load),
            purpose="seismic, least load",
            role="stability",
        ),
        RigTest("P2", benchmark, design.load(), purpose="benchmark again", role="increment"),
    ]
    source = "EN 15129, section 8.3.4, unconfirmed"
    return Program("EN 15129 type tests", tuple(tests), source, code="en15129")


def judge(loops: Sequence[Loops]) -> list[Check]:
    """Return how far restoring stiffness and energy are from the design values.

    The design stiffness is N / R. The design friction is the mean over the cycles of the test at the full displacement and speed; with it the energy of
    the dynamic tests under the same load and speed is judged.
    """
    full = [test for test in loops if test.test.role == "maximum"]
    friction = sum(c.loop_friction for c in full[0].cycles) / len(full[0].cycles) if full else math.nan
    found: list[Check] = []
    for test in loops:
        radius = test.bearing.effective_radius
        stiffness = [abs(c.post_yield_stiffness * radius / c.load - 1.0) for c in test.cycles]
        found.append(
            criterion(
                CODE,
                "8.3.4",
                test.test.name,
                "restoring stiffness of each cycle within 15 % of N / R",
                float(np.max(stiffness)),
                LARGEST_DEVIATION,
            )
        )
        if full and test.test.name in DYNAMIC:
            energy = [abs(c.loop_friction / friction - 1.0) for c in test.cycles]
            found.append(
                criterion(
                    CODE,
                    "8.3.4",
                    test.test.name,
                    f"energy of each cycle within 15 % of that of a friction of {friction:.4f}, the mean of {full[0].test.name}",
                    float(np.max(energy)),
                    LARGEST_DEVIATION,
                )
            )
    return found
