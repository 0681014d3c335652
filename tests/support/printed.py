"""What `print` shows, as numbers again."""

import math
import re

_FACTORS = {"mm": 0.001, "cm": 0.01, "m": 1.0, "deg": math.pi / 180.0, "rad": 1.0, "s": 1.0, "": 1.0}
_PART = re.compile(r"\(([^)]*)\)\s*([a-z]*)|(-?[\d.][\d.e+-]*)\s*([a-z]*)")


def si_numbers(text: str) -> list[float]:
    """Return the numbers of a message in SI units: `3 mm` and `(1, 2, 3) mm (180, 0, 0) deg`."""
    found = []
    for several, unit, one, its_unit in _PART.findall(text):
        factor = _FACTORS[unit or its_unit]
        found += [float(number) * factor for number in (several or one).split(",")]
    return found
