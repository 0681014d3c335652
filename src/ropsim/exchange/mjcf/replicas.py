"""Elements of MJCF that stand several times, one beside the other, with a number behind their names."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.exchange.files.values import name_of, number_of, numbers_of
from ropsim.exchange.files.xml_text import numbers
from ropsim.exchange.files.xml_tree import MOST_ELEMENTS, Element
from ropsim.exchange.losses.diagnostics import XML_REFUSED
from ropsim.exchange.losses.notes import Notes
from ropsim.exchange.mjcf.poses import pose_of
from ropsim.exchange.mjcf.settings import Settings

_ZERO = (0.0, 0.0, 0.0)
_LONGEST = 1_000  # characters that rows add to a name
_JOINTS = {"actuator": ("joint", "jointinparent"), "equality": ("joint1", "joint2")}
"""Attributes that name joints, by section."""


@frozen_dataclass
class _Place:
    """A place in rows in each other.

    Attributes:
        suffixes: that names have there, those of the inner rows first.
        numbers: of its frames in the file, the outer ones first.
    """

    suffixes: tuple[str, ...] = ()
    numbers: tuple[int, ...] = ()

    def inside(self, suffix: str, number: int) -> "_Place":
        """Return the place in a frame of a row that stands here."""
        return _Place((suffix, *self.suffixes), (*self.numbers, number))


def with_replicas(root: Element, settings: Settings, notes: Notes) -> Element | None:
    """Return a file with one world, in which each `replicate` is a row of frames.

    Replica i is turned by i times `euler`, and stands by `offset` beside the one before, in the axes of that.
    Its elements have names with `sep` and i behind them, i with as many digits as the last one has (XML
    reference of MuJoCo). Actuators and constraints that name a joint as it is called in the row, or in a row
    in it, stand behind the others, once for each replica; those with the name of a replica stay.

    Args:
        root: of a file with one world or several.
        settings: of the file.
        notes: for a count that is none, and for a file that becomes too large: then there is none.
    """
    worlds = root.all("worldbody")
    world = replace(worlds[0], children=tuple(one for each in worlds for one in each.children))
    maker = _Maker(settings, notes, _named(root))
    sections = maker.made(world, _Place())
    for name, keys in _JOINTS.items():
        sections += maker.section(root.all(name), keys)
    others = [one for one in root.children if one.name != "worldbody" and one.name not in _JOINTS]
    return None if maker.refused else replace(root, children=(*sections, *others))


def _named(root: Element) -> frozenset[str]:
    """Return the names of joints that actuators and constraints have."""
    return frozenset(
        name
        for section, keys in _JOINTS.items()
        for each in root.all(section)
        for one in each.children
        for name in _names(one, keys)
    )


def _names(element: Element, keys: Iterable[str]) -> list[str]:
    return [name for key in keys if (name := element.attributes.get(key, "").strip())]


class _Maker:
    """Counts the elements that it makes, and keeps the places of joints that others name.

    Those are kept by their name in the row, each as the rest of the suffixes and the numbers of the frames.
    """

    def __init__(self, settings: Settings, notes: Notes, named: frozenset[str]) -> None:
        self._settings, self._notes, self._named = settings, notes, named
        self._copies: dict[str, list[tuple[str, tuple[int, ...]]]] = {}
        self._count = 0
        self.refused = False

    def made(self, element: Element, place: _Place) -> list[Element]:
        """Return an element with the suffixes of a place to its names, or the frames that it stands for."""
        if not self._has_room(element):
            return []
        if element.name == "replicate":
            return self._frames(element, place)
        children = self._contents(element, place)
        if not place.suffixes or "name" not in element.attributes:
            return [replace(element, children=children)]
        if element.name == "joint":
            self._keep(element.attributes["name"].strip(), place)
        return [replace(_renamed(element, "".join(place.suffixes)), children=children)]

    def section(self, sections: Sequence[Element], keys: tuple[str, ...]) -> list[Element]:
        """Return sections as one, with the copies of what names joints in rows behind the others."""
        kept: list[Element] = []
        copied: list[tuple[tuple[int, ...], Element]] = []
        for one in (child for each in sections for child in each.children):
            rows = [self._copies.get(name, []) for name in _names(one, keys)]
            places = [[numbers for _, numbers in row] for row in rows]
            if not rows or not places[0] or any(row != places[0] for row in places):
                kept.append(one)
                continue
            for suffix, frame_numbers in rows[0]:
                if not self._has_room(one):
                    return []
                copied.append((frame_numbers, _renamed(one, suffix, keys)))
        copied.sort(key=lambda each: each[0])
        children = (*kept, *(one for _, one in copied))
        return [replace(each, children=children) for each in sections[:1]]

    def _keep(self, name: str, place: _Place) -> None:
        """Keep a joint under the names that it has in the rows around it, if others name it so."""
        for inner, suffix in enumerate(place.suffixes):
            if name in self._named:
                rest = "".join(place.suffixes[inner:])
                outer = place.numbers[: len(place.numbers) - inner]
                self._copies.setdefault(name, []).append((rest, outer))
            name += suffix

    def _has_room(self, element: Element) -> bool:
        """Count an element; beyond the greatest number none is made (noted once)."""
        self._count += 1
        if self._count > MOST_ELEMENTS:
            self._refuse(element, f"the file has more than {MOST_ELEMENTS} elements")
        return not self.refused

    def _refuse(self, element: Element, words: str) -> None:
        """Make no more elements (noted once)."""
        if not self.refused:
            hint = "cut it down to the robot"
            self._notes.add(XML_REFUSED, element.span, f"with what it replicates {words}", hint)
        self.refused = True

    def _contents(self, element: Element, place: _Place) -> tuple[Element, ...]:
        found: list[Element] = []
        for one in element.children:
            found += self.made(one, place)
        return tuple(found)

    def _frames(self, element: Element, place: _Place) -> list[Element]:
        found: list[Element] = []
        name_of(element, self._notes, "count")
        count, sep = int(number_of(element, "count", self._notes)), element.attributes.get("sep", "")
        offset = np.array(numbers_of(element, "offset", self._notes, _ZERO))
        angles = np.array(numbers_of(element, "euler", self._notes, _ZERO))
        kept = {key: text for key, text in element.attributes.items() if key == "childclass"}
        if sum(map(len, place.suffixes)) + len(sep) > _LONGEST:
            self._refuse(element, f"names become longer by more than {_LONGEST} characters")
        position, digits = np.zeros(3), len(str(count - 1))
        for number in range(count):
            if not self._has_room(element):
                break
            pose = {"pos": numbers(position.tolist()), "euler": numbers((number * angles).tolist())}
            children = self._contents(element, place.inside(f"{sep}{number:0{digits}}", self._count))
            frame = replace(
                element, name="frame", attributes=MappingProxyType(pose | kept), children=children
            )
            found.append(frame)
            position = position + pose_of(frame, self._settings, self._notes).rotation() @ offset
        return found


def _renamed(element: Element, suffix: str, keys: Iterable[str] = ()) -> Element:
    """Return an element with a suffix to its name, and to the names in other attributes."""
    changed = {
        key: element.attributes[key].strip() + suffix
        for key in ("name", *keys)
        if element.attributes.get(key, "").strip()
    }
    return replace(element, attributes=MappingProxyType({**element.attributes, **changed}))
