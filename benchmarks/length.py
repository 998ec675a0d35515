"""How time and memory grow with the length of the record."""

import tracemalloc

import numpy as np
from figure import Figure
from stopwatch import in_turn

import dcfp
from analysis import motion_at

REPEATS = (1, 2, 4, 8, 16, 32, 64)
ROUNDS = 9
MEBIBYTE = 2.0**20


def repeated(motion: dcfp.GroundMotion, times: int) -> dcfp.GroundMotion:
    """Return a motion again and again."""
    return dcfp.GroundMotion(np.tile(motion.acceleration, times), motion.time_step, motion.name)


def exponent(lengths: list[int], values: list[float]) -> float:
    """Return the slope of a straight line through the logarithms, by least squares."""
    return float(np.polyfit(np.log(lengths), np.log(values), 1)[0])


def peak_memory(motion: dcfp.GroundMotion) -> float:
    """Return the most memory that one analysis holds at any time, its result included [B]."""
    tracemalloc.start()
    try:
        dcfp.respond(motion, tail=0.0)
        return float(tracemalloc.get_traced_memory()[1])
    finally:
        tracemalloc.stop()


def figures() -> list[Figure]:
    """Return the exponents of time and memory over the length."""
    motion = motion_at("NCC")
    motions = [repeated(motion, times) for times in REPEATS]
    lengths = [m.acceleration.size for m in motions]
    watches = [lambda m=m: dcfp.respond(m, tail=0.0).elapsed for m in motions]
    medians = [float(np.median(times)) for times in in_turn(watches, ROUNDS)]
    memory = [peak_memory(m) for m in motions]
    each = ", ".join(f"{1e9 * t / n:.0f}" for t, n in zip(medians, lengths, strict=True))
    held = f"{memory[0] / MEBIBYTE:.2f} MiB for {lengths[0]} samples, {memory[-1] / MEBIBYTE:.1f} for {lengths[-1]}"
    return [
        Figure(
            "time over length, exponent", exponent(lengths, medians), at_most=1.05, note=f"{each} ns a sample"
        ),
        Figure("memory over length, exponent", exponent(lengths, memory), at_most=1.05, note=held),
    ]
