"""The figure: what each part of the march brings, and the dispersion over the threshold."""

from pathlib import Path

import matplotlib.pyplot as plt
from ablation import Fineness, Row
from cases import Marks


def draw(
    path: Path,
    ladder: dict[str, Row],
    march: dict[float, Fineness],
    pulse: dict[float, Marks],
) -> None:
    """Draw dispersions of dy: by part of the march on the left, by threshold on the right."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(10.0, 3.6), layout="constrained")
    names = list(ladder)
    left.barh(range(len(names)), [ladder[name].change.dispersion for name in names], color="0.6")
    for i, name in enumerate(names):
        left.text(ladder[name].change.dispersion + 0.005, i, f"× {ladder[name].change.bias:.2f}", va="center")
    left.set_yticks(range(len(names)), [name.replace(", one after", ",\none after") for name in names])
    left.invert_yaxis()
    left.set_xlim(0.0, 0.65)
    left.set_xlabel("dispersion of dy [-]; × bias")
    right.semilogx(
        list(march), [one.row.change.dispersion for one in march.values()], "o-", label="march, dy"
    )
    right.semilogx(
        list(march), [one.row.displacement.dispersion for one in march.values()], "s--", label="march, y"
    )
    right.semilogx(
        list(pulse), [one.change.dispersion for one in pulse.values()], "^-", label="pulse method, dy"
    )
    ticks = [0.02, 0.05, 0.1, 0.2, 0.5]
    right.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    right.minorticks_off()
    right.set_xlabel("threshold or tolerance [PGV]")
    right.set_ylabel("dispersion [-]")
    right.set_ylim(0.0)
    right.legend(frameon=False)
    figure.savefig(path, dpi=110)
    plt.close(figure)
