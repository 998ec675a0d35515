"""A virtual test as a data set with units and provenance."""

import json
from dataclasses import asdict
from typing import TYPE_CHECKING

import numpy as np
import xarray

from dcfp.analysis.rig.summary import cycle_rows
from dcfp.schema.citations import citations_of
from dcfp.schema.nomenclature import quantity
from dcfp.system.profiles import profile_variables
from dcfp.version import version

if TYPE_CHECKING:
    from dcfp.analysis.rig.loops import Loops


def dataset(loops: "Loops") -> xarray.Dataset:
    """Return histories over ``time``, measures over ``cycle``, and provenance as attributes."""
    histories = {
        "displacement": loops.displacement,
        "velocity": loops.velocity,
        "force": loops.force,
        "load": loops.load,
        "friction": loops.friction,
        "temperature": loops.temperature,
        "sliding": loops.sliding,
        "work": loops.work,
        "hysteretic_energy": loops.hysteretic_energy,
    }
    result = xarray.Dataset(
        {name: ("time", np.array(values), quantity(name).attributes) for name, values in histories.items()},
        coords={"time": ("time", np.array(loops.time), quantity("time").attributes)},
        attrs=_provenance(loops),
    )
    return result if loops.profiles is None else result.merge(profile_variables(loops.profiles))


def _provenance(loops: "Loops") -> dict[str, str | float]:
    test = loops.test
    return {
        "Conventions": "CF-1.11",
        "title": f"Virtual test {test.name} of {loops.bearing.name}",
        "source": f"dcfp {version()}",
        "references": "\n".join(citations_of(loops.friction_law.citation, "li_2020")),
        "test": test.name,
        "waveform": test.waveform.kind,
        "begins_s": loops.begins,
        "cycles": json.dumps(cycle_rows(loops)),
        "vertical_load": json.dumps(None if test.load is None else asdict(test.load)),
        "bearing": json.dumps(asdict(loops.bearing)),
        "friction_law": repr(loops.friction_law),
        "heating_model": repr(loops.heating),
        "remarks": " ".join(loops.remarks),
        "elapsed_s": loops.elapsed,
    }
