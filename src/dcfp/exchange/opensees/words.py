"""Words that stand in a script as comments and as strings."""

import textwrap

from dcfp.analysis import Response

#: Longest line of a comment.
_WIDTH = 110


def plain(text: str) -> str:
    """Return text that cannot end a comment: on one line, and without characters that do not print."""
    return "".join(one if one.isprintable() else "?" for one in " ".join(text.split()))


def comment(text: str, *, first: str = "", later: str | None = None) -> list[str]:
    """Return text as lines of comment, which begin with `first` and go on with `later`."""
    indent = " " * len(first) if later is None else later
    wrapped = textwrap.wrap(
        plain(text), _WIDTH - 2, initial_indent=first, subsequent_indent=indent, break_long_words=False
    )
    return [f"# {line}".rstrip() for line in wrapped]


def difference_in_words(response: Response, other: Response) -> str:
    """Return by how much the peak displacement of another analysis is more or less."""
    if response.peak_displacement == 0.0:
        return "where nothing moves"
    change = 100.0 * (other.peak_displacement / response.peak_displacement - 1.0)
    return f"{abs(change):.2f} % {'more' if change >= 0.0 else 'less'} than the {response.peak_displacement:.3f} mm of its own"
