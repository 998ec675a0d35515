"""What methods of codes say, as rows with units in their names, for JSON and CSV."""

from typing import TYPE_CHECKING, Any

from dcfp.present.tables.columns import Column, table_text

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dcfp.methods.panel import Panel
    from dcfp.methods.result import Answer


def answer_object(said: "Answer") -> dict[str, Any]:
    """Return an answer with its verdict, its conditions and its iteration, ready for JSON."""
    return {
        "method": said.method,
        "displacement_mm": said.displacement,
        "base_shear_over_weight": said.base_shear,
        "effective_period_s": said.period,
        "effective_damping": said.damping,
        "within_limits": said.valid if said.conditions else None,
        "verdict": said.verdict,
        "conditions": [
            {
                "name": one.name,
                "verdict": one.verdict.value,
                "found": one.found,
                "limit": one.limit,
                "source": one.source,
                "confirmed": one.confirmed,
            }
            for one in said.conditions
        ],
        "iteration": [
            {
                "displacement_mm": one.displacement,
                "period_s": one.period,
                "damping": one.damping,
                "reduction": one.reduction,
            }
            for one in said.steps
        ],
        "unconfirmed": list(said.unconfirmed),
        "remarks": list(said.remarks),
    }


def panel_object(panel: "Panel") -> dict[str, Any]:
    """Return what every method says of one demand, ready for JSON."""
    return {
        "name": panel.name,
        "pgv_m_s": None if panel.pgv is None else round(panel.pgv / 1e3, 12),
        "friction": panel.pendulum.friction,
        "radius_mm": panel.pendulum.radius,
        "analysis": None
        if panel.displacement is None
        else {"displacement_mm": panel.displacement, "base_shear_over_weight": panel.base_shear},
        "answers": [answer_object(said) for said in panel.answers.values()],
        "without_solution": list(panel.missing),
        "remarks": list(panel.remarks),
    }


def panels_csv(panels: "Sequence[Panel]") -> str:
    """Return a line for each demand and method, the analysis among them."""
    columns = [
        Column("name", "name"),
        Column("pgv_m_s", "pgv", "m s-1"),
        Column("method", "method"),
        Column("displacement_mm", "displacement", "mm"),
        Column("base_shear_over_weight", "base_shear_over_weight", "1"),
        Column("effective_period_s", "effective_period", "s"),
        Column("effective_damping", "effective_damping", "1"),
        Column("verdict", "verdict"),
    ]
    rows: list[dict[str, Any]] = []
    for panel in panels:
        said = panel_object(panel)
        head = {"name": said["name"], "pgv_m_s": said["pgv_m_s"]}
        if said["analysis"] is not None:
            blank = {"effective_period_s": None, "effective_damping": None, "verdict": ""}
            rows.append({**head, "method": "analysis", **said["analysis"], **blank})
        rows += [{**head, **answer} for answer in said["answers"]]
    return table_text(columns, rows)
