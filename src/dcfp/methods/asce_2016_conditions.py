"""Under which conditions the equivalent lateral force procedure may be used: ASCE/SEI 7-16, sections 17.2.4.4 and 17.4.1.

None could be confirmed in the standard. Codes of its family have the same numbers for the period (E.031 of Peru; 4 s in the Turkish code of 2018), the
damping (E.031, the Turkish code and the Italian NTC 2018), the height (E.031 and the Turkish code), the fixed base (E.031 and NTC) and the softening
(E.031). The rise of the force by 0.025 W is that of NTC 2018, 7.10.5.2; AASHTO asks for half of it. For the site class nothing was found but the
Turkish code, which admits its classes ZA to ZD.
"""

from dcfp.methods.equivalent_linear import PendulumWithFriction
from dcfp.methods.result import Condition, Verdict, at_least, at_most
from dcfp.methods.structure import Structure

#: Limits of section 17.4.1: period [s], damping [-], fixed-base periods in a period, stiffness over that at 0.2 D_M, height [mm].
_LONGEST, _MOST_DAMPING, _STIFFER, _SOFTENING, _HEIGHT = 5.0, 0.30, 3.0, 1.0 / 3.0, 65.0 * 304.8
#: Rise of the force between half of D_M and D_M over the weight [-]: section 17.2.4.4.
_RESTORING = 0.025
#: Site classes on which the procedure may be used.
_SITES = ("A", "B", "C", "D")
_SECTION = "17.4.1"


def conditions(
    pendulum: PendulumWithFriction, structure: Structure, D_M: float, T_M: float, beta_M: float
) -> tuple[Condition, ...]:
    """Return the conditions at D_M [mm], T_M [s] and beta_M [-]."""
    softening = pendulum.effective_stiffness(D_M) / pendulum.effective_stiffness(0.2 * D_M)
    restoring = pendulum.force(D_M) - pendulum.force(0.5 * D_M)
    return (
        Condition(
            "effective period T_M",
            at_most(T_M, _LONGEST),
            f"{T_M:.2f} s",
            f"at most {_LONGEST:g} s",
            _SECTION,
            confirmed=False,
        ),
        Condition(
            "effective damping",
            at_most(beta_M, _MOST_DAMPING),
            f"{100 * beta_M:.1f} %",
            "at most 30 %",
            _SECTION,
            confirmed=False,
        ),
        Condition(
            "T_M over the period of the fixed base",
            *structure.over_fixed_base(T_M, _STIFFER),
            "at least 3",
            _SECTION,
            confirmed=False,
        ),
        Condition(
            "k_eff(D_M) over k_eff(0.2 D_M)",
            at_least(softening, _SOFTENING),
            f"{softening:.2f}",
            "above 1/3",
            _SECTION,
            confirmed=False,
        ),
        Condition(
            "restoring force, F(D_M) - F(D_M/2) over W",
            at_least(restoring, _RESTORING),
            f"{restoring:.3f}",
            "at least 0.025",
            "17.2.4.4",
            confirmed=False,
        ),
        Condition(
            "height of the structure above",
            Verdict.NOT_KNOWN if structure.height is None else at_most(structure.height, _HEIGHT),
            "not given" if structure.height is None else f"{structure.height / 1e3:.1f} m",
            "at most 65 ft (19.8 m), or four storeys",
            _SECTION,
            confirmed=False,
        ),
        Condition(
            "site class",
            Verdict.NOT_KNOWN
            if structure.site_class is None
            else (Verdict.MET if structure.site_class in _SITES else Verdict.NOT_MET),
            structure.site_class or "not given",
            "A, B, C or D",
            _SECTION,
            confirmed=False,
        ),
    )
