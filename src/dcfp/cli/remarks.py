"""What a reader of the numbers must know beside them."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dcfp.record.ground_motion import GroundMotion
    from dcfp.response import Response

_SCALING = "scaled by"


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
