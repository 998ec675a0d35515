"""Incremental dynamic analysis: what every record does as it gets stronger, and what parts of the records do not exceed.

After Vamvatsikos and Cornell (2002), with the intensity of the study in place of a spectral acceleration.
"""

from collections.abc import Sequence

import xarray

from dcfp.study.assessment.completeness import (
    few_records,
    is_beyond_capacity,
    quantiles_over_records,
    remarks_of,
    usable,
    with_references,
    with_remarks,
)
from dcfp.study.assessment.selection import intensity_of, only, sorted_over

#: Parts of the records that do not exceed [-]: the median and one standard deviation of a normal distribution on either side.
QUANTILES = (0.16, 0.5, 0.84)


def ida(
    dataset: xarray.Dataset,
    quantity: str = "peak_displacement",
    quantiles: Sequence[float] = QUANTILES,
    *,
    unfinished: bool = False,
) -> xarray.Dataset:
    """Return the curves of an incremental dynamic analysis.

    Parameters
    ----------
    dataset
        A study of which at most the records and the intensity have several values; see `dcfp.study.assessment.select`.
    quantity
        The result that is looked at; of a residual displacement the size.
    quantiles
        Parts of the records [-].
    unfinished
        Whether analyses that have not been run are left out rather than refused.

    Returns
    -------
    xarray.Dataset
        `quantity` over ``record`` and the intensity; ``<quantity>_quantile`` over ``quantile`` and the intensity; ``beyond_capacity``, whether an
        analysis is beyond the displacement capacity of the bearing.

    Raises
    ------
    InputError
        If another factor has several values, or the study is not finished.
    """
    intensity = intensity_of(dataset)
    chosen = only(dataset, ("record", intensity), "An incremental dynamic analysis")
    found = usable(sorted_over(chosen, intensity), [quantity], unfinished=unfinished)
    beyond = is_beyond_capacity(found)
    curves = found[[quantity]].assign(
        {
            f"{quantity}_quantile": quantiles_over_records(found[quantity], quantiles),
            "beyond_capacity": beyond,
        }
    )
    remarks = [*remarks_of(found), *few_records(quantiles, found.sizes["record"])]
    if beyond.any():
        remarks.append(
            f"{int(beyond.sum())} of the {beyond.size} analyses are beyond the displacement capacity; they are those of plates without an end."
        )
    return with_remarks(with_references(curves, "vamvatsikos_cornell_2002"), remarks)
