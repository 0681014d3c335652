"""Meaning of a contract clause: the gripper, the numbers of locations and parameters."""

import re

from ropsim.core import frozen_dataclass
from ropsim.flow import GripAction

_NUMBERS = {
    word: n
    for n, word in enumerate(
        ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"]
    )
}
_COUNT = r"\b(\d{1,3}|" + "|".join(_NUMBERS) + r")\s+(?:reference\s+|scalar\s+)?"
_LOCATIONS = re.compile(_COUNT + r"locations?\b", re.IGNORECASE)
_PARAMETERS = re.compile(_COUNT + r"parameters?\b", re.IGNORECASE)
_GRIPPER = re.compile(r"\bgripper\s+(?:is\s+|to\s+be\s+)?(open|close)d?\b", re.IGNORECASE)


@frozen_dataclass
class Clause:
    """Parsed contract clause.

    Attributes:
        text: all its words on one line.
        gripper: state the gripper must have, or None.
        locations: number of reference locations, or None.
        parameters: number of scalar parameters, or None.
    """

    text: str
    gripper: GripAction | None
    locations: int | None
    parameters: int | None


def understand(text: str) -> Clause:
    """Return the meaning of a contract clause; words without a meaning are documentation."""
    words = " ".join(text.split())
    gripper = _GRIPPER.search(words)
    action = GripAction(gripper.group(1).lower()) if gripper else None
    return Clause(words, action, _count(_LOCATIONS, words), _count(_PARAMETERS, words))


def _count(pattern: re.Pattern[str], text: str) -> int | None:
    match = pattern.search(text)
    if not match:
        return None
    word = match.group(1).lower()
    return int(word) if word.isdigit() else _NUMBERS[word]
