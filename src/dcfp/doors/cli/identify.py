"""``dcfp identify``: a law of friction from measured tests."""

import argparse
import json
from pathlib import Path

from dcfp.analysis.rig import read_measurement
from dcfp.doors.cli import inputs
from dcfp.doors.cli.console import Block, Page, grid
from dcfp.doors.cli.outputs import Answer, drawn
from dcfp.errors import InputError
from dcfp.inference.identification import Identification, bearing_file, identify
from dcfp.inference.identification.result import ESTIMATES, HELD, RESIDUALS, Estimate, predicted_table
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import NONE
from dcfp.system import FittedFriction
from dcfp.version import version

_FORM = (
    "mu = mu_0 gamma alpha beta; gamma = (1 - pressure_floor) (p / reference_pressure)^-pressure_exponent + pressure_floor,"
    " alpha = 1 - speed_drop exp(-speed_rate |v|), beta = exp(-temperature_rate (T - reference_temperature))"
)


def run(chosen: argparse.Namespace) -> Answer:
    """Fit the law, and predict what was held out."""
    system = inputs.system(chosen)
    if system.friction.name not in ("fitted", "li2020"):
        msg = f"{chosen.bearing}: the law that is fitted has the form 'fitted', that of Li et al. (2020) with free constants, and not {system.friction.name!r}; leave [friction] out."
        raise InputError(msg)
    found = identify(
        [read_measurement(file) for file in chosen.files],
        system.bearing,
        system.heating,
        fit=chosen.fit,
        fixed=chosen.fix,
        law=system.friction if isinstance(system.friction, FittedFriction) else None,
        held_out=[read_measurement(file) for file in chosen.hold_out],
    )

    def data(part: Path, kind: str) -> str:
        if kind == ".toml":
            return bearing_file(found.system, _origin(found))
        return (
            found.csv() if kind == ".csv" else f"{json.dumps(found.summary(), indent=2, allow_nan=False)}\n"
        )

    return Answer(found.summary, lambda: _page(found), data, drawn("plot_identification", found))


def _origin(found: Identification) -> tuple[str, ...]:
    """Return what the head of a bearing file says of where its law comes from."""
    tests = ", ".join(f"{h.name} (SHA-256 {h.measurement.digest[:12]})" for h in found.histories)
    return (
        f"dcfp {version()}: law fitted to {tests}",
        *(
            f"{one.name} = {one.value:.6g}, 95 % interval {one.lower:.6g} to {one.upper:.6g} {one.unit}".strip()
            for one in found.estimates
        ),
        *(f"{one.name} held: {one.reason}" for one in found.held),
        *found.remarks,
    )


def _page(found: Identification) -> Page:
    bearing, heating = found.system.bearing, found.system.heating
    radii = " + ".join(f"{radius:g}" for radius in bearing.radii)
    blocks: list[Block] = [
        [
            ("Bearing", f"{bearing.name}: radius {radii} mm, slider {bearing.slider_diameter:g} mm"),
            ("Law", _FORM),
            ("Heating", f"{heating.name}, from {heating.ambient:g} °C"),
        ],
        grid(Table(tuple(ESTIMATES), found.estimates)),
        grid(Table(tuple(HELD), found.held)),
    ]
    if len(found.estimates) > 1:
        blocks.append(grid(_correlation(found)))
    blocks.append(grid(Table(tuple(RESIDUALS), found.residuals)))
    if found.predictions:
        blocks.append(grid(predicted_table(found.predictions)))
    notes = [
        f"Intervals: leaving out one of {found.blocks} blocks (strokes) after another, so that errors within a stroke may depend on each other.",
        *(
            f"{one.name}: the force that was predicted is {100.0 * one.force_error:.1f} % of the largest measured one away from it (root mean square)."
            for one in found.predictions
        ),
    ]
    return Page(blocks, [*notes, *found.remarks])


def _correlation(found: Identification) -> Table:
    """Return the correlation of every estimate with every other."""

    def column(place: int, one: Estimate) -> Quantity:
        head = one.name.replace("_", "\n", 1) if len(one.name) > 6 else f"{one.name}\n"
        return Quantity(one.name, "correlation", NONE, decimals=3, head=head, get=lambda row: row[1][place])

    columns = [column(place, one) for place, one in enumerate(found.estimates)]
    rows = list(zip(found.estimates, found.correlation.tolist(), strict=True))
    return Table((Quantity("Correlation", "estimate", get=lambda row: row[0].name), *columns), rows)
