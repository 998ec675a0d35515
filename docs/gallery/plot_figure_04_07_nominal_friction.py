"""
Figures 4 and 7: reference and nominal friction
===============================================

**In the paper**: Figure 4 takes the reference coefficient μ₀ from the start of the fast test T01, Figure 7 the nominal coefficient μₙ = 0.043 from its second cycle (points c and d).

**Here**: the virtual machine in the dependency test, with the precise and the simplified heating model and the constant μₙ. The second cycle of the model is 9 % (precise) and 14 % (simplified) below the
tests. Nothing was calibrated; which effects would reduce the difference is in :doc:`/virtual_tests`.
"""

import dcfp
from dcfp.analysis.rig.run import paper_models
from dcfp.present.figures.overviews import plot_dependency
from dcfp.system import PreciseHeating, System

program = dcfp.load_program("dependency")
models = paper_models(System(heating=PreciseHeating()))
runs = {name: dcfp.run_program(program, model) for name, model in models.items()}
figure = plot_dependency(program, runs, {})

for model, tests in runs.items():
    nominal = tests[0].cycles[1].friction
    print(
        f"{model:<10} μ at zero displacement, cycle 2: {nominal:.4f}, from 0.043 {100 * (nominal / 0.043 - 1):+.0f} %"
    )
