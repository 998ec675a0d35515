"""Where the sample records are, which are not part of the project."""

import os
from pathlib import Path


def sample_folder() -> Path | None:
    """The folder of sample records: DCFP_SAMPLE_RECORDS, or ../shared/records beside the repository."""
    named = os.environ.get("DCFP_SAMPLE_RECORDS")
    folder = Path(named) if named else Path(__file__).resolve().parents[3] / "shared" / "records"
    return folder if (folder / "INDEX.tsv").is_file() else None
