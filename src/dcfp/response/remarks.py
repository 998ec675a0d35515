"""What a reader of an analysis must know beside its numbers."""

from dcfp.record.remarks import motion_remarks
from dcfp.response.response import Response


def remarks_on(response: Response) -> list[str]:
    """Return every remark on one analysis."""
    return [*motion_remarks(response.motion), *response.remarks]
