"""Elements of MJCF that stand several times, one beside the other, with a number behind their names."""

from dataclasses import replace
from types import MappingProxyType

import numpy as np

from ropsim.exchange.files.values import name_of, number_of, numbers_of
from ropsim.exchange.files.xml_text import numbers
from ropsim.exchange.files.xml_tree import MOST_ELEMENTS, Element
from ropsim.exchange.losses.diagnostics import XML_REFUSED
from ropsim.exchange.losses.notes import Notes
from ropsim.exchange.mjcf.poses import pose_of
from ropsim.exchange.mjcf.settings import Settings

_ZERO = (0.0, 0.0, 0.0)


def with_replicas(world: Element, settings: Settings, notes: Notes) -> Element | None:
    """Return a world in which each `replicate` is a row of frames; None if it becomes too large (noted).

    Replica i is turned by i times `euler`, and stands by `offset` beside the one before, in the axes of that.
    Its elements have names with `sep` and i behind them, i with as many digits as the last one has (XML
    reference of MuJoCo).
    """
    maker = _Maker(settings, notes)
    found = maker.made(world, "")
    return None if maker.count > MOST_ELEMENTS else found[0]


class _Maker:
    def __init__(self, settings: Settings, notes: Notes) -> None:
        self._settings, self._notes = settings, notes
        self.count = 0

    def made(self, element: Element, suffix: str) -> list[Element]:
        """Return an element with a suffix to its names, or the frames that it stands for."""
        if not self._has_room(element):
            return []
        if element.name == "replicate":
            return self._frames(element, suffix)
        attributes = dict(element.attributes)
        if suffix and "name" in attributes:
            attributes["name"] += suffix
        children = self._contents(element, suffix)
        return [replace(element, children=children, attributes=MappingProxyType(attributes))]

    def _has_room(self, element: Element) -> bool:
        """Count an element; beyond the greatest number none is made (noted once)."""
        self.count += 1
        if self.count == MOST_ELEMENTS + 1:
            words = f"with what it replicates the file has more than {MOST_ELEMENTS} elements"
            self._notes.add(XML_REFUSED, element.span, words, "cut it down to the robot")
        return self.count <= MOST_ELEMENTS

    def _contents(self, element: Element, suffix: str) -> tuple[Element, ...]:
        found: list[Element] = []
        for one in element.children:
            found += self.made(one, suffix)
        return tuple(found)

    def _frames(self, element: Element, suffix: str) -> list[Element]:
        found: list[Element] = []
        name_of(element, self._notes, "count")
        count, sep = int(number_of(element, "count", self._notes)), element.attributes.get("sep", "")
        offset = np.array(numbers_of(element, "offset", self._notes, _ZERO))
        angles = np.array(numbers_of(element, "euler", self._notes, _ZERO))
        kept = {key: text for key, text in element.attributes.items() if key == "childclass"}
        position, digits = np.zeros(3), len(str(count - 1))
        for number in range(count):
            if not self._has_room(element):
                break
            place = {"pos": numbers(position.tolist()), "euler": numbers((number * angles).tolist())}
            children = self._contents(element, f"{sep}{number:0{digits}}{suffix}")
            frame = replace(
                element, name="frame", attributes=MappingProxyType(place | kept), children=children
            )
            found.append(frame)
            position = position + pose_of(frame, self._settings, self._notes).rotation() @ offset
        return found
