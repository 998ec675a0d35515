"""
The march along straight legs
=============================

A prediction that carries velocity, position and heat over from one straight leg of the ground velocity to the next, beside the analysis. Its derivation is in :doc:`/prediction`.
"""

import dcfp
from dcfp.present.figures import plot_pulses

motion = dcfp.load_motion("NCC").scaled_to_pgv(500.0)
case = dcfp.compare(motion, keep_response=True)
march = dcfp.march_through_pulses(motion, with_path=True)
figure = plot_pulses(case, march)

print(
    f"y_max {march.prediction.displacement:.1f} mm by the march, {case.analysed.whole.bound:.1f} mm by the analysis"
)
