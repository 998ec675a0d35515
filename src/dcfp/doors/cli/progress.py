"""A progress bar for work that takes long, on a terminal only."""

import sys
from collections.abc import Callable, Generator
from contextlib import contextmanager
from threading import Timer

#: Time before a bar appears [s].
PATIENCE = 2.0


@contextmanager
def progress(words: str, total: int | None) -> Generator[Callable[[], None]]:
    """Show how many of `total` pieces of work (None: not known) are done; call what it gives after each."""
    if not sys.stderr.isatty():
        yield lambda: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    bar = Progress(
        TextColumn(words),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        console=Console(stderr=True),
        transient=True,
    )
    task = bar.add_task(words, total=total)
    # a timer, because the first piece of work may be the one that takes long: the kernels are compiled in it
    timer = Timer(PATIENCE, bar.start)
    timer.daemon = True
    timer.start()
    try:
        yield lambda: bar.advance(task)
    finally:
        timer.cancel()
        bar.stop()
