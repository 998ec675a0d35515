"""Sections of parameters in docstrings: what is written stays, and what is declared is added."""

from typing import Annotated

from dcfp.schema.declared import Declared, declared, with_parameters
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import KN_PER_MM, MM
from dcfp.system import SimplifiedHeating


@declared
class Thing(Declared):
    """A thing.

    Parameters
    ----------
    stiffness
        By hand [N/mm]:
        two lines.

    Notes
    -----
    It has notes.
    """

    length: Annotated[float | None, Parameter("its length", MM, symbol="L", absent="not known")] = None
    stiffness: Annotated[float, Parameter("its stiffness", KN_PER_MM)] = 1.0
    word: Annotated[str, Parameter("a word")] = ""
    other: int = 3


def test_what_is_written_stays_and_what_is_declared_is_added_in_the_order_of_the_fields() -> None:
    assert Thing.__doc__ == (
        "A thing.\n\nParameters\n----------\n"
        "length\n    Its length, :math:`L` [mm]; None: not known.\n"
        "stiffness\n    By hand [N/mm]:\n    two lines.\n"
        "word\n    A word.\n\n"
        "Notes\n-----\nIt has notes."
    )


def test_a_section_is_made_before_the_others_where_there_is_none() -> None:
    assert with_parameters("What.\n\n    Raises\n    ------\n    E\n        If.", {"a": "It."}) == (
        "What.\n\nParameters\n----------\na\n    It.\n\nRaises\n------\nE\n    If."
    )
    assert with_parameters("What.", {}) == "What."


def test_inherited_parameters_are_in_the_docstring() -> None:
    assert "Temperature at the start, :math:`T_0` [degC]." in (SimplifiedHeating.__doc__ or "")
