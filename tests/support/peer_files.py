"""Record files as PEER writes them."""

from pathlib import Path

import numpy as np

STEP = 0.02


def write_peer(path: Path, about: str, pgv: float, offset: float = 0.0) -> Path:
    """Write two seconds of a wave at 1 Hz with rest around it, of that PGV [mm/s], plus an offset [mm/s2]; `about` is earthquake, date, station, component."""
    time = np.arange(300) * STEP
    wave = np.where((time >= 1.0) & (time <= 3.0), np.sin(2.0 * np.pi * time), 0.0)
    velocity = np.cumsum(wave) * STEP  # that of straight lines, where the wave is zero
    wave = wave * pgv / velocity.max() + offset
    head = f"PEER NGA STRONG MOTION DATABASE RECORD\n{about}\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS=  {wave.size}, DT=  {STEP:.4f} SEC\n"
    path.write_text(head + "".join(f"{value:.7E}\n" for value in wave / 9806.65))
    return path
