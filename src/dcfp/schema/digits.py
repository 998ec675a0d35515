"""Numbers in words and digits: as text of a console has them, and as they are typeset, with a true minus sign."""


def fixed(value: float, decimals: int = 0, *, signed: bool = False) -> str:
    """Return a number with so many decimals, without a minus before a zero; `signed` puts a plus before a positive one."""
    text = f"{value:{'+' if signed else ''}.{decimals}f}"
    return text.removeprefix("-") if float(text) == 0.0 else text


def true_minus(text: str) -> str:
    """Return a number, or words with numbers, with true minus signs for hyphens."""
    return text.replace("-", "−")


def typeset(value: float, decimals: int = 0) -> str:
    """Return a number with so many decimals as it is typeset."""
    return true_minus(fixed(value, decimals))


def millimetres(value: float) -> str:
    """Return a length [mm] with as many decimals as it deserves."""
    decimals = 0 if abs(value) >= 10.0 else 1 if abs(value) >= 1.0 else 2
    return f"{typeset(value, decimals)} mm"


def metres_per_second(value: float) -> str:
    """Return a velocity given in mm/s."""
    velocity = value / 1e3
    return f"{velocity:.2f} m/s" if velocity >= 0.095 else f"{velocity:.2g} m/s"
