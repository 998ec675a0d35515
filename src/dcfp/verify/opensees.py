r"""OpenSees, an independent program, on the same bearing under the same records.

Its heated element ``FPBearingPTV`` is for a single concave bearing with the law of Kumar, Whittaker and Constantinou (2015). What
its source does otherwise, and what that amounts to here:

* it also heats while the bearing only deforms elastically: this is compared with an explicit integration that does the same;
* it sums the convolution by the rectangle rule, which is low by :math:`1.46\sqrt{\Delta t}` of the present flux: removed by extrapolation
  in :math:`\sqrt{\Delta t}` and :math:`\Delta t`;
* it writes pi as 22/7 (the rise is low by 6e-4), has the restoring force :math:`N u/\sqrt{R^2 - u^2}`, and takes the friction of the step before.

In the plane its friction turns with the velocity to the first order of the step, which the same extrapolation removes from the displacement too.

On the virtual test machine its values are extrapolated in :math:`\sqrt{\Delta t}` only: where the slider leaves the monitoring point its
error also has a part of the order of a step that is not smooth, and another term would magnify it.
"""

import json
import math
import os
import subprocess
import sys
import tempfile
from dataclasses import replace
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from dcfp.analysis import respond
from dcfp.analysis.rig import Loops, Sine
from dcfp.arrays import FloatArray
from dcfp.exchange.opensees import model_script
from dcfp.exchange.opensees.element import Element, Kind
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.station import Station
from dcfp.system import ConstantFriction, NoHeating, SimplifiedHeating
from dcfp.system.friction.kumar_2015 import VELOCITY_RATE
from dcfp.verify import explicit, plane_explicit, rig_explicit
from dcfp.verify.check import CannotCheckError, Found, scaled_record, scaled_station
from dcfp.verify.explicit import KUMAR, SINGLE_CONCAVE
from dcfp.verify.rig import SINES, run_one

#: If this is "1", a check that cannot be made for want of OpenSees fails.
REQUIRED = "DCFP_REQUIRE_OPENSEES"
_GET_IT = "OpenSees cannot be run: install the Python package openseespy, and on Linux the libraries libblas3 and liblapack3"
_PROGRAM = Path(__file__).with_name("opensees_driver.py")
_PATIENCE = 600.0  # [s]
#: Steps of the heated analyses [s], and in a cycle of the test machine; the convolution takes time with the square of their number.
_STEPS, _STEPS_IN_CYCLE = (0.004, 0.002, 0.001), (2000, 4000)
#: Steps of the brute-force integration in a cycle.
_FINE = 8000
_STEEL = SimplifiedHeating()
_HEATED = Element(Kind.HEATED, KUMAR.mu_reference, rate=VELOCITY_RATE)
#: By how much the rise is low for 22/7, and what part of an extrapolation is allowed [-].
_PI, _EXTRAPOLATED = 6e-4, 0.2
#: Seconds of the records that hold their peaks; what comes after them would only take time.
_STRONG = {
    "NCC": 10.0,
    "KNA": 15.0,
    "LPG": 8.0,
    "IVD": 40.0,
    "P695-FF-2": 8.0,
    "P695-FF-7": 11.0,
    "P695-FF-14": 7.0,
}
#: Step over that of the record of the analyses in the plane where nothing heats [-].
_PART_IN_PLANE = 0.1


def _missing(why: str = "it is not installed") -> CannotCheckError:
    fails = os.environ.get(REQUIRED) == "1"
    end = f" {REQUIRED} is 1, so this is a failure." if fails else ""
    return CannotCheckError(f"{_GET_IT} ({why}).{end}", fails=fails)


@cache
def _strong(record: str) -> GroundMotion:
    """Return the part of a record at 0.5 m/s that holds its peaks."""
    return _beginning(scaled_record(record, 500.0), _STRONG[record])


@cache
def _strong_pair(station: str) -> Station:
    """Return the part of a station at 0.5 m/s that holds its peaks."""
    pair = scaled_station(station, 500.0)
    return replace(pair, **{axis: _beginning(getattr(pair, axis), _STRONG[station]) for axis in ("x", "y")})


def _beginning(motion: GroundMotion, seconds: float) -> GroundMotion:
    return replace(motion, acceleration=motion.acceleration[: round(seconds / motion.time_step) + 1])


def analyse(**job: Any) -> dict[str, Any]:
    """Run OpenSees in a process of its own, each job once.

    Parameters
    ----------
    **job
        What the driver takes; a record or a station by its name; a coefficient of friction for a bearing that does not heat.

    Raises
    ------
    CannotCheckError
        If OpenSees cannot be imported or does not finish.
    """
    require()  # also where its results are at hand
    return run_job(tuple(job.items()))


def require() -> None:
    """Raise a CannotCheckError if OpenSees is not installed."""
    if find_spec("openseespy") is None:
        raise _missing()


@cache
def run_job(given: tuple[tuple[str, Any], ...]) -> dict[str, Any]:
    """Run a job; errors as of `analyse`."""
    job_of = dict(given)
    element = Element(Kind.COULOMB, job_of.pop("friction")) if "friction" in job_of else _HEATED
    plane = "station" in job_of
    if plane or "record" in job_of:
        motion = _strong_pair(job_of.pop("station")) if plane else _strong(job_of.pop("record"))
        columns = np.atleast_2d(motion.acceleration.T).tolist()
        job_of |= {"accelerations": columns, "interval": motion.time_step}
    with tempfile.TemporaryDirectory() as folder:
        job, result = Path(folder, "job.json"), Path(folder, "result.json")
        job.write_text(json.dumps(job_of), encoding="utf-8")
        model = model_script(element, SINGLE_CONCAVE, _STEEL, plane=plane)
        Path(folder, "model.py").write_text(model, encoding="utf-8")
        run_apart(_PROGRAM, job, result)
        return dict(json.loads(result.read_text(encoding="utf-8")))


def run_apart(*words: Path) -> None:
    """Run a Python program with arguments in a process of its own; the last one is the file that it writes.

    Raises
    ------
    CannotCheckError
        If it does not write it.
    """
    command = [sys.executable, *map(str, words)]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=_PATIENCE, check=False)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise _missing(str(error)) from error
    if not words[-1].exists():
        last = (done.stderr.strip() or done.stdout.strip() or "no message").splitlines()[-1]
        raise _missing(last)


def coulomb(record: str) -> Found:
    """Return the peak displacement under constant friction, and that of OpenSees [mm]."""
    theirs = analyse(record=record, step=0.001, friction=ConstantFriction().mu)
    ours = respond(
        _strong(record), SINGLE_CONCAVE, ConstantFriction(), NoHeating(), tail=0.0
    ).peak_displacement
    curvature = 100.0 * (ours / SINGLE_CONCAVE.effective_radius) ** 2
    words = {"failed": theirs["failed_steps"], "curvature": curvature}
    return Found(ours, theirs["peak_displacement"], words=words)


def extrapolated(values: tuple[float, float, float]) -> float:
    """Return the limit of values at `_STEPS` whose error is a sqrt(step) + b step."""
    steps = np.array(_STEPS)
    terms = np.column_stack((np.ones(3), np.sqrt(steps), steps))
    return float(np.linalg.solve(terms, np.array(values))[0])


@cache
def _twin() -> explicit.Peaks:
    """Return the peaks of an integration that heats as OpenSees does."""
    return explicit.integrate(_strong("NCC"), SINGLE_CONCAVE, KUMAR, _STEEL, heats_while_sticking=True)


def temperature() -> Found:
    """Return the peak temperature of an integration that heats as OpenSees does, and that of OpenSees [degC]."""
    runs = [analyse(record="NCC", step=step)["peak_temperature"] for step in _STEPS]
    theirs, twin = extrapolated((runs[0], runs[1], runs[2])), _twin().temperature
    ours = respond(_strong("NCC"), SINGLE_CONCAVE, KUMAR, _STEEL, tail=0.0).peak_temperature
    words = {"runs": ", ".join(f"{value:.2f}" for value in runs), "theirs": theirs, "ours": ours}
    limit = _PI * (twin - 20.0) + _EXTRAPOLATED * abs(theirs - runs[-1])
    return Found(twin, theirs, limit, words)


def displacement() -> Found:
    """Return the peak displacement of an integration that heats as OpenSees does, and that of OpenSees [mm]."""
    run, twin = analyse(record="NCC", step=_STEPS[-1]), _twin()
    ours = respond(_strong("NCC"), SINGLE_CONCAVE, KUMAR, _STEEL, tail=0.0).peak_displacement
    warm, warmer = KUMAR.temperature_factor(np.array([run["peak_temperature"], twin.temperature]))
    return Found(twin.displacement, run["peak_displacement"], float(warm / warmer) - 1.0, {"ours": ours})


# ----- in the plane -----


def coulomb_in_plane(station: str) -> Found:
    """Return the peak displacement in the plane under constant friction, and that of OpenSees [mm]."""
    pair = _strong_pair(station)
    step = _PART_IN_PLANE * pair.time_step
    theirs = analyse(station=station, step=step, friction=ConstantFriction().mu)
    ours = respond(pair, SINGLE_CONCAVE, ConstantFriction(), NoHeating(), tail=0.0).peak_displacement
    words = {"failed": theirs["failed_steps"], "step": 1e3 * step}
    return Found(ours, theirs["peak_displacement"], words=words)


@cache
def _twin_in_plane(station: str) -> plane_explicit.Outcome:
    """Return an integration in the plane that heats as OpenSees does."""
    law = np.array(KUMAR.at_pressure(SINGLE_CONCAVE.pressure)[1:])  # without its form
    return plane_explicit.integrate(
        _strong_pair(station), SINGLE_CONCAVE, law, _STEEL, heats_while_sticking=True
    )


def heated_in_plane(station: str, quantity: str) -> Found:
    """Return the peak displacement [mm] or temperature [degC] in the plane of an integration that heats as OpenSees does, and that of OpenSees."""
    runs = [analyse(station=station, step=step)[quantity] for step in _STEPS]
    twin = _twin_in_plane(station)
    ours = respond(_strong_pair(station), SINGLE_CONCAVE, KUMAR, _STEEL, tail=0.0)
    words = {"runs": ", ".join(f"{value:.2f}" for value in runs), "ours": getattr(ours, quantity)}
    found = {"peak_displacement": twin.peak, "peak_temperature": float(twin.temperature.max())}
    return Found(found[quantity], extrapolated((runs[0], runs[1], runs[2])), words=words)


# ----- on the virtual test machine, taken through the cycles of a sine -----


def _through(test: str, steps_per_cycle: int) -> dict[str, Any]:
    """Take the bearing through a test of `SINES` with OpenSees; errors as of `analyse`."""
    _, amplitude, peak_velocity, cycles = SINES[test]
    return analyse(
        amplitude=amplitude, peak_velocity=peak_velocity, cycles=cycles, steps_per_cycle=steps_per_cycle
    )


@cache
def _outcome(test: str) -> rig_explicit.Outcome:
    """Return the test by an integration that heats as OpenSees does."""
    _, amplitude, peak_velocity, cycles = SINES[test]
    law = np.array(KUMAR.at_pressure(SINGLE_CONCAVE.pressure)[1:])  # without its form
    path = rig_explicit.sine(amplitude, peak_velocity, cycles, _FINE)
    return rig_explicit.integrate(path, SINGLE_CONCAVE, law, _STEEL, heats_while_sticking=True)


@cache
def _on_machine(test: str) -> Loops:
    _, amplitude, peak_velocity, cycles = SINES[test]
    return run_one(Sine(amplitude, peak_velocity, cycles), _STEEL, KUMAR, bearing=SINGLE_CONCAVE)


def _limit(coarse: FloatArray, fine: FloatArray) -> FloatArray:
    """Return the limit of values at `_STEPS_IN_CYCLE` whose error goes with the root of the step."""
    return fine + (fine - coarse) / (math.sqrt(_STEPS_IN_CYCLE[1] / _STEPS_IN_CYCLE[0]) - 1.0)


def rig_temperature(test: str) -> Found:
    """Return the peak temperature of an integration that heats as OpenSees does, and that of OpenSees [degC]."""
    coarse, fine = (np.array([max(_through(test, steps)["temperature"])]) for steps in _STEPS_IN_CYCLE)
    theirs, twin = float(_limit(coarse, fine)[0]), float(_outcome(test).temperature.max())
    words = {
        "runs": f"{coarse[0]:.2f} and {fine[0]:.2f}",
        "theirs": theirs,
        "ours": _on_machine(test).peak_temperature,
    }
    limit = _PI * (twin - _STEEL.ambient) + _EXTRAPOLATED * abs(theirs - float(fine[0]))
    return Found(twin, theirs, limit, words)


def rig_friction(test: str) -> Found:
    """Return the coefficient at zero displacement that differs most from that of OpenSees, and theirs [-]."""
    load, cycles = SINGLE_CONCAVE.vertical_force, SINES[test][3]
    coarse, fine = (
        np.abs(np.array(_through(test, steps)["force"])[steps // 2 - 1 :: steps // 2]) / load
        for steps in _STEPS_IN_CYCLE
    )
    theirs = _limit(coarse, fine)
    twin = np.abs(_outcome(test).force[_FINE // 2 :: _FINE // 2]) / load
    ours = _on_machine(test)
    half = (ours.time.size - 1) // (2 * cycles)
    machine = np.abs(ours.force[half::half]) / load
    errors = twin / theirs - 1.0
    worst = int(np.abs(errors).argmax())
    words = {
        "passage": worst + 1,
        "passages": errors.size,
        "theirs": fine[worst],
        "machine": machine[worst],
    }
    limit = _PI + _EXTRAPOLATED * float(np.abs(fine / theirs - 1.0).max())
    return Found(float(twin[worst]), float(theirs[worst]), limit, words)
