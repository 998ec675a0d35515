"""
Spectra of a set of records
===========================

Elastic response and input energy of the four records at 0.5 m/s.
"""

import dcfp
from dcfp.methods.spectra import input_energy_spectrum
from dcfp.present.figures.motions import plot_spectra

motions = [
    dcfp.load_motion(name).scaled_to_pgv(500.0) for name in ("NCC", "KNA", "LPG", "IVD")
]
figure = plot_spectra(
    [input_energy_spectrum(motion) for motion in motions], [500.0] * 4
)
