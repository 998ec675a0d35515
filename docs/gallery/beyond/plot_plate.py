"""
Temperature along the plate
===========================

The precise model in the test T06 of Table 2 (±400 mm, three cycles): the contact keeps moving onto cooler parts of the plate, which is why one point at the centre is not sufficient.
"""

import dcfp
from dcfp.analysis.rig import run_program
from dcfp.present.figures.drawing import plot_test

program = dcfp.load_program("asce")
loops = run_program(
    program.only(["T06"]),
    dcfp.LI_2020,
    dcfp.Li2020(),
    dcfp.PreciseHeating(),
    keep=dcfp.Keep(every=20),
)
figure = plot_test(loops[0])
