"""What every method is that says how far a bearing moves; and the registry of them all, over which tables, figures, reports, studies and comparisons loop."""

from dataclasses import dataclass
from enum import StrEnum
from typing import NamedTuple

from dcfp.schema.registry import Registry


class Information(StrEnum):
    """What a method knows of an earthquake."""

    PGV = "PGV only"
    BLIND = "blind"
    INFORMED = "informed"
    SPECTRUM = "spectrum"

    @property
    def words(self) -> str:
        """What it is, without an article."""
        words = {"PGV": "PGV", "BLIND": "record", "INFORMED": "record and analysis", "SPECTRUM": "spectrum"}
        return words[self.name]


class Variant(NamedTuple):
    """The name of a method, with what it knows."""

    method: str
    information: Information


@dataclass(frozen=True)
class Look:
    """How the results of a method are drawn; what is empty is the next one that is free."""

    marker: str = ""  #: as Matplotlib names it
    colour: str = ""  #: of the figures (blue, ochre, red, grey, ink), or any that Matplotlib knows
    scale: float = 1.0  #: size of the marker over that of others [-]
    order: int = 2  #: what is drawn over what: the larger one on top


@dataclass(frozen=True, kw_only=True)
class Method:
    """What is common to all methods; one that is made, in a module of its own, is in the registry."""

    key: str  #: name in studies
    name: str  #: name in tables and results
    knows: tuple[Information, ...]  #: what it can do its work with; several where it gives a result for each
    head: str = ""  #: name at the head of a narrow column; by default the name
    citations: tuple[str, ...] = ()  #: keys of its sources in the bibliography
    look: Look = Look()  #: in figures

    def __post_init__(self) -> None:
        METHODS.add(self.key, self)

    @property
    def variants(self) -> tuple[Variant, ...]:
        """The method with each of what it knows."""
        return tuple(Variant(self.name, information) for information in self.knows)


#: Every method by its key, in the order of tables.
METHODS: Registry[Method] = Registry("method")


def variants() -> tuple[Variant, ...]:
    """Return every method with what it knows, in the order of tables: blind reads the record, informed also which pulse the analysis found to govern."""
    return tuple(variant for method in METHODS.values() for variant in method.variants)
