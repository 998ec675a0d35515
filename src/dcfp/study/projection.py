"""How long a study will take: a few blocks are worked off, spread over the whole, and nothing is kept."""

import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial

import numpy as np

from dcfp.study.plan import Block, Plan
from dcfp.study.results import QUANTITIES
from dcfp.study.work import work_off

#: Parts that are tried for each thread, and analyses in each at most.
_TRIED, _MOST_ANALYSES = 12, 64


@dataclass(frozen=True)
class Projection:
    """What is to be expected of a study.

    Attributes
    ----------
    analyses, blocks
        Number of each.
    tried
        Analyses that were timed.
    rate
        Analyses per second on all threads together [1/s].
    duration
        Of all analyses [s].
    size
        Of the results, uncompressed [byte].
    """

    analyses: int
    blocks: int
    tried: int
    rate: float
    duration: float
    size: int


def project(plan: Plan, threads: int) -> Projection:
    """Time some analyses of a plan on so many threads, and say what all of them will take.

    Analyses cost about as much as their records are long; what the tried ones cost is scaled by that.
    """
    blocks = list(plan.blocks())
    chosen: list[int] = np.unique(
        np.linspace(0, len(blocks) - 1, _TRIED * threads).round().astype(int)
    ).tolist()
    parts = [_part(blocks[number]) for number in chosen]
    work_off(plan, _part(blocks[0], 1))  # compiles, or loads what is compiled
    began = time.perf_counter()
    with ThreadPoolExecutor(threads) as pool:
        list(pool.map(partial(work_off, plan), parts))
    elapsed = time.perf_counter() - began
    tried = sum(part.size for part in parts)
    cost = sum(plan.cost(part) for part in parts)
    duration = elapsed * sum(plan.cost(block) for block in blocks) / cost
    numbers = len(QUANTITIES) + len(plan.study.histories) * plan.longest_record
    return Projection(
        plan.count, len(blocks), tried, plan.count / duration, duration, plan.count * (8 * numbers + 1)
    )


def _part(block: Block, most: int = _MOST_ANALYSES) -> Block:
    """Return the middle of a block, with no more analyses than that: neither the weakest nor the strongest motions alone."""
    region = list(block.region)
    while Block(block.number, tuple(region)).size > most:
        longest = max(range(len(region)), key=lambda axis: region[axis].stop - region[axis].start)
        length = region[longest].stop - region[longest].start
        begin = region[longest].start + (length - length // 2) // 2
        region[longest] = slice(begin, begin + length // 2)
    return Block(block.number, tuple(region))
