"""Numbers as they are written into figures."""


def number(value: float, decimals: int = 0) -> str:
    """Return a number with a true minus sign, and without one before a zero."""
    text = f"{value:.{decimals}f}"
    return text.replace("-", "" if float(text) == 0.0 else "−")


def millimetres(value: float) -> str:
    """Return a length [mm] with as many decimals as it deserves."""
    decimals = 0 if abs(value) >= 10.0 else 1 if abs(value) >= 1.0 else 2
    return f"{number(value, decimals)} mm"


def metres_per_second(value: float) -> str:
    """Return a velocity given in mm/s."""
    velocity = value / 1e3
    return f"{velocity:.2f} m/s" if velocity >= 0.095 else f"{velocity:.2g} m/s"
