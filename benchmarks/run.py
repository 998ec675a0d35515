"""Measure every figure of speed that this package has a goal for, on one core but for studies; print one table."""

import argparse
import json
import os
import sys
import warnings

from figure import Figure, table

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS"):
    os.environ[variable] = "1"  # read when the parts import numpy

PARTS = (
    "opensees",
    "plane",
    "handwritten",
    "heating",
    "rig",
    "prediction",
    "spectrum",
    "study",
    "length",
    "laws",
    "startup",
)


def measure(part: str) -> list[Figure]:
    """Return the figures of one part."""
    print(f"measuring: {part}", file=sys.stderr)
    return __import__(part).figures()


def main() -> int:
    """Run the parts that the command line names, or all; return 1 if a goal is missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("parts", nargs="*", default=[], metavar="PART", help=f"any of {', '.join(PARTS)}")
    parser.add_argument("--json", action="store_true", help="print one JSON document")
    arguments = parser.parse_args()
    unknown = set(arguments.parts) - set(PARTS)
    if unknown:
        parser.error(f"there is no part {', '.join(sorted(unknown))}; the parts are {', '.join(PARTS)}")
    warnings.simplefilter("ignore")
    figures = [figure for part in arguments.parts or PARTS for figure in measure(part)]
    print(
        json.dumps([figure.to_json() for figure in figures], indent=2) if arguments.json else table(figures)
    )
    return 1 if any(figure.met is False for figure in figures) else 0


if __name__ == "__main__":
    sys.exit(main())
