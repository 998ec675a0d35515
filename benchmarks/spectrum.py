"""Response spectra of all components of FEMA P-695, and one of them against eqsig and against sdof where these are installed."""

import importlib
from typing import Any

import numpy as np
from figure import Figure
from stopwatch import in_turn, once

from dcfp.inference.forecast import calibration_set
from dcfp.methods.spectra import input_energy_spectrum, response_spectrum
from dcfp.methods.spectra.of_record import PERIODS
from dcfp.motion.named import named_motion

ROUNDS = 3


def all_spectra() -> None:
    """Make the response spectrum of every component."""
    for motion in calibration_set():
        response_spectrum(motion)


def of_eqsig(module: Any) -> Figure:
    """Return how long eqsig takes for the spectrum of one record, over our time."""
    motion = named_motion("NCC")

    def theirs() -> None:
        signal = module.AccSignal(motion.acceleration, motion.time_step)
        signal.generate_response_spectrum(response_times=PERIODS, xi=0.05)

    ours = in_turn([lambda: once(lambda: response_spectrum(motion))], 9)[0]
    other = in_turn([lambda: once(theirs)], ROUNDS)[0]
    note = f"NCC, {motion.acceleration.size} samples: {1e3 * np.median(other):.0f} ms over {1e3 * np.median(ours):.2f} ms"
    return Figure("eqsig over ours", float(np.median(other) / np.median(ours)), at_least=30.0, note=note)


def of_sdof(module: Any) -> Figure:
    """Return how long sdof's integrator takes for the spectrum of one record, over our time."""
    motion = named_motion("NCC")

    def theirs() -> None:
        for omega in (2.0 * np.pi / PERIODS).tolist():
            module.integrate(-motion.acceleration, motion.time_step, k=omega**2, c=0.1 * omega, m=1.0)

    ours = in_turn([lambda: once(lambda: response_spectrum(motion))], 9)[0]
    other = in_turn([lambda: once(theirs)], ROUNDS)[0]
    note = f"NCC: {1e3 * np.median(other):.0f} ms over {1e3 * np.median(ours):.2f} ms; its integrator is compiled C"
    return Figure("sdof over ours", float(np.median(other) / np.median(ours)), at_least=30.0, note=note)


def figures() -> list[Figure]:
    """Return the time of all spectra, and the ratios to other packages."""
    response_spectrum(named_motion("NCC"))
    spectra = float(np.median(in_turn([lambda: once(all_spectra)], ROUNDS)))
    energy = once(lambda: [input_energy_spectrum(motion) for motion in calibration_set()])
    found = [
        Figure("200 periods, 100 components", spectra, "s", at_most=1.0, note="response spectra, one core"),
        Figure("the same with energies", energy, "s", note="relative and absolute input energy"),
    ]
    for name, measure in (("eqsig", of_eqsig), ("sdof", of_sdof)):
        try:
            module = importlib.import_module(name)
        except ImportError:
            found.append(Figure(f"{name} over ours", None, at_least=30.0, note=f"{name} is not installed"))
            continue
        found.append(measure(module))
    return found
