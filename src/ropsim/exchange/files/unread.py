"""Attributes of a file that are not read, reported by the names of element and attribute."""

from collections.abc import Iterator, Set

from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.gathered import Topic
from ropsim.exchange.losses.loss_diagnostics import LOST_DESCRIPTION, LOST_DRIVE, LOST_MOTION
from ropsim.exchange.losses.notes import Notes

UNREAD = Topic(LOST_DESCRIPTION, "attributes", "attributes {} are not read")
"""Attributes that nothing depends on."""
UNREAD_DRIVE = Topic(LOST_DRIVE, "attributes", "attributes {} are not read")
"""Attributes of limits, friction and drives, whose lack is reported where the model needs them."""
UNREAD_MOTION = Topic(
    LOST_MOTION,
    "attributes",
    "attributes {} are not read, but change motion or weight",
    "describe the robot without them",
)
"""Attributes without which the robot moves or weighs otherwise."""


def unread(element: Element, known: Set[str]) -> Iterator[str]:
    """Yield the attributes of an element that are not known; declarations of name spaces are none.

    Args:
        element: of a file.
        known: names of attributes.
    """
    return (key for key in element.attributes if key not in known and not key.startswith("xmlns"))


def note_unread(element: Element, key: str, topic: Topic, notes: Notes) -> None:
    """Note an attribute that is not read, as `element/attribute`.

    Args:
        element: that has it.
        key: its name.
        topic: of this module, by the use of the attribute.
        notes: for the loss.
    """
    notes.gather(topic, element.span, [f"{element.name}/{key}"])
