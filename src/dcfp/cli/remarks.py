"""What a reader of the numbers must know beside them."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dcfp.record.ground_motion import GroundMotion
    from dcfp.response import Response

_SCALING = "scaled by"


def grouped(remarks: "Iterable[tuple[str, str]]") -> list[str]:
    """Return remarks, each given with the name that it may begin with; what is said of several names is said once."""
    names: dict[str, list[str]] = {}
    for name, remark in remarks:
        told = remark.removeprefix(f"{name}: ")
        names.setdefault(told, []).extend([name] if told != remark else [])
    return [
        f"{', '.join(dict.fromkeys(members))}: {told}" if members else told for told, members in names.items()
    ]


def remarks_on(response: "Response") -> list[str]:
    """Return every remark on one analysis."""
    return [*motion_remarks(response.motion), *response.remarks]


def motion_remarks(motion: "GroundMotion", *, with_scale: bool = True) -> list[str]:
    """Return what was done to a motion, and whether its baseline is in doubt."""
    from dcfp.record.measures import baseline_warning

    steps = [step for step in motion.treatment if with_scale or not step.startswith(_SCALING)]
    remarks = [f"{motion.name}: {'; '.join(steps)}."] if steps else []
    warning = baseline_warning(motion)
    return [*remarks, *([warning] if warning else [])]
