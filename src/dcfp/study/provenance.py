"""What a store says of where its numbers come from, and by what two studies are told apart."""

import hashlib
import json
from dataclasses import asdict
from typing import Any

import numpy as np

from dcfp.errors import InputError
from dcfp.kernels._jit import source_digest
from dcfp.schema.citations import citations_of
from dcfp.schema.identity import identity_of
from dcfp.study.plan import Plan
from dcfp.study.results import DIGEST
from dcfp.system import friction_law
from dcfp.version import version

#: Form of the store, so that a later version knows what it has before it.
FORM = 1


def provenance(plan: Plan) -> dict[str, Any]:
    """Return the attributes of the results of a study."""
    study = plan.study
    attributes: dict[str, Any] = {
        "Conventions": "CF-1.11",
        "title": study.title,
        "source": f"dcfp {version()}",
        **makers(),
        "store_form": FORM,
        DIGEST: digest(plan),
        "study_name": study.name,
        "study": study.text,
        "references": "\n".join(citations_of(*_citations(plan), "li_2020")),
        "bearing": json.dumps(asdict(study.model.bearing)),
        "friction_law": repr(study.model.friction),
        "heating_model": repr(study.model.heating),
        "settings": json.dumps(asdict(study.settings)),
        "records": json.dumps(_records(plan)),
        "sampling_method": "grid" if study.sampling is None else study.sampling.method,
    }
    capacity = _capacity(plan)
    if capacity is not None:
        attributes["displacement_capacity"] = capacity
    if study.sampling is not None:
        sampled = [{"name": name, "distribution": repr(one)} for name, one in study.sampling.factors.items()]
        attributes |= {"sampling_seed": study.sampling.seed, "sampling_factors": json.dumps(sampled)}
    return attributes


def makers() -> dict[str, str]:
    """Return which versions make the numbers."""
    return {"version": version(), "kernels_sha256": source_digest()}


def _capacity(plan: Plan) -> float | None:
    """Return the displacement capacity that all bearings of a study have [mm], if they have the same."""
    capacities = {model.bearing.displacement_capacity for model in plan.models_at_ends()}
    return capacities.pop() if len(capacities) == 1 else None


def digest(plan: Plan) -> str:
    """Return a number that two studies share only if every analysis of them is the same, and every result the same to the last bit."""
    study = plan.study
    whole = {
        **makers(),
        "form": FORM,
        "grid": {name: _exactly(list(values)) for name, values in study.factors.items()},
        "samples": {name: _exactly(np.asarray(values).tolist()) for name, values in plan.samples.items()},
        "records": [(motion.name, motion.digest) for motion in study.motions],
        "model": identity_of(study.model),
        "bearings": {name: identity_of(model) for name, model in study.bearings.items()},
        "settings": identity_of(study.settings),
        "histories": study.histories,
        "chunks": plan.chunks,
    }
    return hashlib.sha256(json.dumps(whole).encode()).hexdigest()


def _exactly(values: list[Any]) -> list[Any]:
    """Return values as they can be written without loss."""
    return [value.hex() if isinstance(value, float) else value for value in values]


def _citations(plan: Plan) -> list[str]:
    laws = {plan.study.model.friction.citation}
    for name in plan.study.factors.get("law", plan.samples.get("law", [])):
        try:
            laws.add(friction_law(str(name)).citation)
        except InputError:  # a law that needs parameters is that of the study's own model
            continue
    return sorted(laws)


def _records(plan: Plan) -> list[dict[str, Any]]:
    return [
        {
            "name": motion.name,
            "sha256": motion.digest,
            "origin": asdict(motion.origin),
            "treatment": list(motion.treatment),
            "time_step_s": motion.time_step,
            "samples": motion.acceleration.size,
            "pgv_mm_s": motion.peak_velocity,
            "pga_mm_s2": motion.peak_acceleration,
        }
        for motion in plan.study.motions
    ]
