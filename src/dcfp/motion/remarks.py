"""What a reader of a motion's numbers must know beside them."""

from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.measures import baseline_warning

_SCALING = "scaled by"


def motion_remarks(motion: GroundMotion, *, with_scale: bool = True) -> list[str]:
    """Return what was done to a motion, and whether its baseline is in doubt."""
    steps = [step for step in motion.treatment if with_scale or not step.startswith(_SCALING)]
    remarks = [f"{motion.name}: {'; '.join(steps)}."] if steps else []
    warning = baseline_warning(motion)
    return [*remarks, *([warning] if warning else [])]
