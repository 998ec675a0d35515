"""From options to how records are predicted."""

import argparse
from dataclasses import replace
from typing import TYPE_CHECKING

from dcfp.doors.cli.parser import Parser, fraction, number_from, positive

if TYPE_CHECKING:
    from dcfp.doors.cli import inputs
    from dcfp.inference import Setting
    from dcfp.inference.nominal import Nominal


def add_method(parser: Parser) -> None:
    """Add the constants of the methods."""
    group = parser.add_argument_group(
        "prediction", "Constants of the methods of Li et al. (2020); by default the paper's."
    )
    group.add_argument(
        "--nominal-mu",
        type=fraction(),
        metavar="VALUE",
        help="constant coefficient mu_n that stands for the law [-]; default 0.043 for the paper's law, else what the virtual test T01 gives",
    )
    group.add_argument(
        "--eps", type=number_from(1e-3, 10.0), metavar="VALUE", help="eps of Eq. (26) [-]; default 0.25"
    )
    group.add_argument(
        "--zeta", type=number_from(0.1, 10.0), metavar="VALUE", help="zeta of Eq. (29) [-]; default 1.5"
    )
    group.add_argument(
        "--average-slope",
        type=positive("mm/s2", 10.0, 1e5),
        metavar="MM_PER_S2",
        help="kg_ave of Eq. (28), at a PGV of 0.25 m/s [mm/s2]; default 930",
    )
    group.add_argument(
        "--threshold",
        type=fraction(),
        metavar="VALUE",
        help="part of PGV by which the ground velocity must turn back for a peak to count [-]; default 0.2",
    )


def nominal(chosen: argparse.Namespace, model: "inputs.System") -> "Nominal":
    """Return the nominal coefficient and where it comes from."""
    from dcfp.inference.nominal import Nominal, nominal_coefficient

    if chosen.nominal_mu is not None:
        return Nominal(chosen.nominal_mu, "as given")
    return nominal_coefficient(model.bearing, model.friction, model.heating)


def setting(chosen: argparse.Namespace, model: "inputs.System") -> "tuple[Setting, Nominal]":
    """Return how records are predicted, and where the nominal coefficient comes from."""
    from dcfp.inference import Setting
    from dcfp.methods.li_2020 import LI_2020

    found = nominal(chosen, model)
    given = {
        "nominal_friction": found.value,
        "fall_ratio": chosen.eps,
        "change_ratio": chosen.zeta,
        "average_slope": chosen.average_slope,
    }
    constants = replace(LI_2020, **{name: value for name, value in given.items() if value is not None})
    made = Setting(model.bearing, model.friction, model.heating, constants)
    return (made if chosen.threshold is None else replace(made, threshold=chosen.threshold)), found
