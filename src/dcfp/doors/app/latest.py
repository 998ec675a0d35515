"""Calculations of which only the latest matters."""

from collections.abc import Awaitable, Callable

from nicegui import background_tasks


class Latest:
    """Does a piece of work again whenever it is asked to, one at a time; what is asked meanwhile is done once, with the latest values.

    Parameters
    ----------
    work
        Looks up what is wanted, calculates in another thread, and shows it.
    """

    def __init__(self, work: Callable[[], Awaitable[None]]) -> None:
        self._work = work
        self._wanted = False
        self._runs = False

    @property
    def outdated(self) -> bool:
        """Whether something newer is wanted than what is being done."""
        return self._wanted

    def ask(self) -> None:
        """Do the work, now or after the present one."""
        self._wanted = True
        if not self._runs:
            self._runs = True
            background_tasks.create(self._run())

    async def _run(self) -> None:
        try:
            while self._wanted:
                self._wanted = False
                await self._work()
        finally:
            self._runs = False
