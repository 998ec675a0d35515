"""Are the paper's methods worse where they say that they are? ``python awkward.py RECORD...`` for names, sets and files of records, such as P695."""

import sys
from collections.abc import Sequence

import numpy as np
from cases import Array, analyses
from reports import Report
from tables import table

from dcfp.analysis import Response
from dcfp.methods.li_2020.constants import PULSE, SIMPLIFIED
from dcfp.methods.prediction import Ground, Methods, prediction_methods
from dcfp.motion.load import load_motions

#: Words of a remark by its reason.
REASONS = {"ku/kg from 0.8": "ku/kg", "plateau": "plateau", "ripples": "ripples", "any": "unreliable"}


def remarks_and_errors(method: str, responses: Sequence[Response]) -> tuple[list[str], Array]:
    """Return what a method remarks of each record, and the logarithm of its dy over that of the analysis, where it predicts a motion."""
    remarks: list[str] = []
    errors: list[float] = []
    for one in responses:
        predicted = prediction_methods()[method].predict(Ground.of(one.motion), Methods())
        assert predicted is not None
        if (change := predicted.prediction.displacement_change) > 0.0:
            remarks.append(" ".join(predicted.remarks))
            errors.append(np.log(change / one.peak_change))
    return remarks, np.array(errors)


def _texts(errors: Array) -> list[str]:
    beyond = np.mean(np.abs(errors) > np.log(2.0))
    return [str(errors.size), f"{np.exp(errors.mean()):.2f}", f"{errors.std(ddof=1):.2f}", f"{beyond:.0%}"]


def awkward(report: Report, responses: Sequence[Response]) -> None:
    """Report bias, dispersion and the share off by more than a factor of two, of dy, with and without each remark."""
    rows: list[list[str]] = []
    for method in (PULSE, SIMPLIFIED):
        remarks, errors = remarks_and_errors(method, responses)
        for reason, word in REASONS.items():
            told = np.array([word in one for one in remarks])
            rows.append([f"{method}, {reason}", *_texts(errors[told]), *_texts(errors[~told])])
    head = ["cases", "bias", "disp.", "off by 2"]
    report("With a remark, and without", table(["method, remark", *head, *head], rows))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit("usage: python awkward.py RECORD...")
    awkward(Report(), analyses(load_motions(sys.argv[1:])))
