"""What every method is that says how far a bearing moves: its name, what it knows, how it is drawn; and the registry of them all.

A method is one module that registers a `CodeMethod` or a `PredictionMethod`: tables, figures, reports, studies and comparisons loop over the registry.
"""

from dataclasses import dataclass
from enum import StrEnum
from typing import NamedTuple, TypeVar

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
    """A method with what it knows.

    Attributes
    ----------
    method
        Name of the method.
    information
        What it knows.
    """

    method: str
    information: Information


@dataclass(frozen=True)
class Look:
    """How the results of a method are drawn.

    Attributes
    ----------
    marker
        As Matplotlib names it; empty for the next one that is free.
    colour
        A colour of the figures (blue, ochre, red, grey, ink), or any that Matplotlib knows; empty for the next one that is free.
    scale
        Size of the marker over that of others [-].
    order
        What is drawn over what: the larger one on top.
    """

    marker: str = ""
    colour: str = ""
    scale: float = 1.0
    order: int = 2


@dataclass(frozen=True, kw_only=True)
class Method:
    """What is common to all methods.

    Attributes
    ----------
    key
        Name in studies.
    name
        Name in tables and results.
    knows
        What it can do its work with; several where it gives a result for each.
    head
        Name at the head of a narrow column; by default the name.
    citations
        Keys of its sources in the bibliography.
    look
        In figures.
    """

    key: str
    name: str
    knows: tuple[Information, ...]
    head: str = ""
    citations: tuple[str, ...] = ()
    look: Look = Look()

    @property
    def variants(self) -> tuple[Variant, ...]:
        """The method with each of what it knows."""
        return tuple(Variant(self.name, information) for information in self.knows)


#: Every method by its key, in the order of tables.
METHODS: Registry[Method] = Registry("method")

M = TypeVar("M", bound=Method)


def register(method: M) -> M:
    """Add a method to the registry, and return it."""
    METHODS.add(method.key, method)
    return method


def variants() -> tuple[Variant, ...]:
    """Return every method with what it knows, in the order of tables: blind reads the record, informed also which pulse the analysis found to govern."""
    return tuple(variant for method in METHODS.values() for variant in method.variants)
