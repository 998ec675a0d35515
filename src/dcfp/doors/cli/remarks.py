"""What a reader of the numbers must know beside them."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable


def grouped(remarks: "Iterable[tuple[str, str]]") -> list[str]:
    """Return remarks, each given with the name that it may begin with; what is said of several names is said once."""
    names: dict[str, list[str]] = {}
    for name, remark in remarks:
        told = remark.removeprefix(f"{name}: ")
        names.setdefault(told, []).extend([name] if told != remark else [])
    return [
        f"{', '.join(dict.fromkeys(members))}: {told}" if members else told for told, members in names.items()
    ]
