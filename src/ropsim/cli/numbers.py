"""Numbers as the command line prints them."""


def shown(value: float, decimals: int) -> float:
    """Return a number rounded for printing, without a negative zero."""
    return round(float(value), decimals) + 0.0
