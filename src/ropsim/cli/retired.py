"""Codes of earlier versions: their meaning then, and what holds instead. They never mean anything else."""

from collections.abc import Mapping

from ropsim.core import frozen_dataclass


@frozen_dataclass
class RetiredCode:
    """A code that is no longer reported.

    Attributes:
        slug: the pattern it named, in kebab case.
        meaning: what it reported, in one line.
        now: what holds instead, in a sentence.
    """

    slug: str
    meaning: str
    now: str


RETIRED: Mapping[str, RetiredCode] = {
    "M504": RetiredCode(
        "speed-limit-on-line",
        "a LIN move needs a joint speed above the limit",
        "The path is slowed down there, and M563 says so.",
    ),
    "M507": RetiredCode(
        "zone-not-simulated",
        "the move has a zone, the simulation stops at the target instead",
        "Zones are simulated. M560 names one that becomes a stop, M562 one that is flown smaller.",
    ),
    "M510": RetiredCode(
        "acceleration-limit",
        "a LIN move needs a joint acceleration above the limit",
        "The path is slowed down there, and M563 says so.",
    ),
    "M521": RetiredCode(
        "external-axis-on-line",
        "a LIN move has a target whose external axes stand elsewhere",
        "External axes move on lines, arcs and curves.",
    ),
    "M571": RetiredCode(
        "chain-too-long",
        "the arm has more joints than straight-line code is generated for",
        "Long arms are computed by loops over the chain.",
    ),
    "M574": RetiredCode(
        "inertia-not-symmetric",
        "the inertia tensor of a link is not symmetric",
        "X862 names the place in the file.",
    ),
    "X904": RetiredCode(
        "looks-like-radians",
        "an angle in degrees has the digits of a right angle in radians",
        "X822 reports it, in robot files and cell files.",
    ),
    "X910": RetiredCode(
        "robot-file-outside-project",
        "the path of a robot file leads out of the project folder",
        "U962 reports every file that lies outside the project.",
    ),
    "X913": RetiredCode(
        "tiny-part",
        "a part of which no edge has a millimetre",
        "X824 reports it.",
    ),
}
"""By code."""
