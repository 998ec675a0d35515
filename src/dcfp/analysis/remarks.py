"""What a reader of an analysis must know beside its numbers."""

from dcfp.analysis.response import Response
from dcfp.motion.remarks import motion_remarks


def remarks_on(response: Response) -> list[str]:
    """Return every remark on one analysis."""
    return [*motion_remarks(response.motion), *response.remarks]
