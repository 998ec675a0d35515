"""A response as a data set with units and provenance."""

import json
from dataclasses import asdict
from typing import TYPE_CHECKING

import numpy as np
import xarray

from dcfp.schema.citations import citations_of
from dcfp.schema.nomenclature import quantity
from dcfp.system.profiles import profile_variables
from dcfp.version import version

if TYPE_CHECKING:
    from dcfp.analysis.response import Response


def dataset(response: "Response") -> xarray.Dataset:
    """Return histories as variables over ``time``, and peaks and provenance as attributes."""
    energy = response.energy
    histories = {
        "ground_acceleration": response.ground_acceleration,
        "ground_velocity": response.ground_velocity,
        "displacement": response.displacement,
        "velocity": response.velocity,
        "structure_velocity": response.structure_velocity,
        "structure_acceleration": response.structure_acceleration,
        "force": response.force,
        "friction": response.friction,
        "temperature": response.temperature,
        "sliding": response.sliding,
        "input_energy": energy.input,
        "absolute_input_energy": energy.absolute_input,
        "kinetic_energy": energy.kinetic,
        "strain_energy": energy.strain,
        "hysteretic_energy": energy.hysteretic,
        "energy_residual": energy.residual,
    }
    result = xarray.Dataset(
        {name: ("time", np.array(values), quantity(name).attributes) for name, values in histories.items()},
        coords={"time": ("time", np.array(response.time), quantity("time").attributes)},
        attrs=_provenance(response),
    )
    return result if response.profiles is None else result.merge(profile_variables(response.profiles))


def _provenance(response: "Response") -> dict[str, str | float]:
    motion = response.motion
    law = response.friction_law
    return {
        "Conventions": "CF-1.11",
        "title": f"Response of {response.bearing.name} under {motion.name}",
        "source": f"dcfp {version()}",
        "references": "\n".join(citations_of(response.friction_law.citation, "li_2020")),
        **response.summary(),
        "remarks": " ".join(response.remarks),
        "record_sha256": motion.digest,
        "record_origin": json.dumps(asdict(motion.origin)),
        "record_treatment": "; ".join(motion.treatment) or "none",
        "bearing": json.dumps(asdict(response.bearing)),
        "friction_law": repr(law),
        "heating_model": repr(response.heating),
        "settings": json.dumps(asdict(response.settings)),
    }
