"""The figures of a case, in heights that let both stand on one page."""

from dataclasses import replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from dcfp.analysis import Response
    from dcfp.methods.li_2020 import Constants
    from dcfp.study.scenario import Result

#: Heights of the sheet of the analysis with the temperature along the plates, and of the pulses [in].
_SHEET_WITH_PROFILE, _PULSES = 5.35, 3.55
#: Characters of a record's name that the head of a figure has room for.
_LONGEST = 40


def draw_response(result: "Result") -> "Figure":
    """Draw loop and histories."""
    from dcfp.present.figures import plot_response  # late: Matplotlib takes long to import

    figure = plot_response(_named_shortly(result.response))
    if result.response.profiles is not None:
        figure.set_figheight(_SHEET_WITH_PROFILE)
    return figure


def draw_pulses(result: "Result", constants: "Constants") -> "Figure":
    """Draw the pulses, the velocities and the displacement."""
    from dcfp.present.figures import plot_pulses

    case = replace(result.case, record=_short(result.case.record))
    figure = plot_pulses(case, response=result.response, constants=constants)
    figure.set_figheight(_PULSES)
    return figure


def _named_shortly(response: "Response") -> "Response":
    name = _short(response.motion.name)
    return (
        response
        if name == response.motion.name
        else replace(response, motion=replace(response.motion, name=name))
    )


def _short(name: str) -> str:
    return name if len(name) <= _LONGEST else f"{name[: _LONGEST - 1]}…"
