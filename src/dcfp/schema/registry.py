"""Registries: what can be added to the package by one module, found by name at every door."""

from collections.abc import Iterator, Mapping
from importlib.metadata import entry_points
from typing import Generic, TypeVar

from dcfp.errors import InputError
from dcfp.schema.parameters import unknown

T = TypeVar("T")

#: Group of entry points whose modules are imported when names are asked for: what they define registers itself.
PLUGINS = "dcfp.plugins"
_state = {"loaded": False}


class Registry(Mapping[str, T], Generic[T]):
    """Things of one kind by their names, in the order in which they were added.

    Parameters
    ----------
    noun
        What one of them is called in a sentence.
    """

    def __init__(self, noun: str) -> None:
        self.noun = noun
        self._things: dict[str, T] = {}

    def add(self, name: str, thing: T) -> T:
        """Add a thing under a name; a later one replaces an earlier one of the same name."""
        self._things[name] = thing
        return thing

    def remove(self, name: str) -> None:
        """Take a thing away again."""
        del self._things[name]

    @property
    def defined(self) -> Mapping[str, T]:
        """What there is so far, without what other packages add: for a module that is only being imported."""
        return self._things

    def find(self, name: object, where: str = "") -> T:
        """Return the thing of that name, in any case of letters.

        Raises
        ------
        InputError
            If there is none; the sentence begins with `where`.
        """
        key = name.strip().lower() if isinstance(name, str) else name
        if not isinstance(key, str) or key not in self:
            prefix = f"{where}: " if where else ""
            msg = f"{prefix}{unknown(name, self, self.noun)}"
            raise InputError(msg)
        return self[key]

    def __getitem__(self, name: str) -> T:
        _load_plugins()
        return self._things[name]

    def __iter__(self) -> Iterator[str]:
        _load_plugins()
        return iter(self._things)

    def __len__(self) -> int:
        _load_plugins()
        return len(self._things)


def _load_plugins() -> None:
    """Import what other installed packages add, once in a process."""
    if _state["loaded"]:
        return
    _state["loaded"] = True
    for entry in entry_points(group=PLUGINS):
        entry.load()
