"""Settings of an MJCF file: units of angles, order of Euler angles, folders, and defaults by class."""

from collections.abc import Mapping
from math import radians
from types import MappingProxyType

from ropsim.core import Span, frozen_dataclass
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.diagnostics import BAD_NUMBER, UNKNOWN_ENTITY
from ropsim.exchange.losses.gathered import shown
from ropsim.exchange.losses.notes import Notes
from ropsim.exchange.mjcf.defaults import MAIN, Defaults, defaults_of, kind_of, merged
from ropsim.exchange.mjcf.keywords import Keyword, says
from ropsim.exchange.mjcf.weight_rules import WeightRules, weight_rules


@frozen_dataclass
class Settings:
    """Settings of a whole file.

    Attributes:
        angle_unit: radians in one unit of angles of the file.
        euler_order: of Euler angles, such as `xyz`; capitals turn about fixed axes.
        autolimits: whether a range alone is in force, without an attribute that says so.
        weights: rules for the weights of bodies.
        mesh_folder: folder of meshes relative to the file.
        strips_paths: whether names of files count without their folders (`strippath`).
        defaults: classes by name.
    """

    angle_unit: float
    euler_order: str
    autolimits: bool
    weights: WeightRules
    mesh_folder: str
    strips_paths: bool
    defaults: Defaults

    def whole(self, element: Element, inherited: str) -> Element:
        """Return an element with the attributes that its class adds to its own.

        Args:
            element: of the file.
            inherited: class of the bodies around it, where it says none.
        """
        name = element.attributes.get("class", inherited)
        added = self.defaults.get(name, self.defaults[MAIN]).of(kind_of(element))
        attributes = MappingProxyType(merged(added, element.attributes))
        return Element(element.name, attributes, element.children, element.span, element.text)


def settings_of(root: Element, notes: Notes) -> Settings:
    """Return the settings of a file; later elements of a name extend earlier ones."""
    compiler: dict[str, str] = {}
    span = root.span
    for one in root.all("compiler"):
        compiler |= one.attributes
        span = one.span
    _check(compiler, span, notes)
    whole = Element("compiler", MappingProxyType(compiler), (), span)
    return Settings(
        1.0 if compiler.get("angle", "degree") == "radian" else radians(1.0),
        compiler.get("eulerseq", "xyz"),
        says(whole, "autolimits", notes, Keyword.TRUE),
        weight_rules(whole, notes),
        compiler.get("meshdir", compiler.get("assetdir", "")),
        says(whole, "strippath", notes),
        defaults_of(root, notes),
    )


def _check(compiler: Mapping[str, str], span: Span, notes: Notes) -> None:
    """Note settings that would place bodies elsewhere if they were read as others."""
    order = compiler.get("eulerseq", "xyz")
    if len(order) != 3 or set(order.lower()) - set("xyz"):
        words = f'`compiler` has eulerseq="{shown(order)}", allowed are three of x, y, z, X, Y, Z'
        notes.add(BAD_NUMBER, span, words, "write such as xyz")
    angle = compiler.get("angle", "degree")
    if angle not in ("degree", "radian"):
        words = f'`compiler` has angle="{shown(angle)}", allowed are degree and radian'
        notes.add(BAD_NUMBER, span, words, "write one of these words")
    if compiler.get("coordinate", "local") != "local":
        words = f'`compiler` has coordinate="{shown(compiler["coordinate"])}", allowed is local'
        notes.add(BAD_NUMBER, span, words, "save the file by a newer MuJoCo")


def class_of(element: Element, key: str, inherited: str, settings: Settings, notes: Notes) -> str:
    """Return the class that an element says, if the file defines it (noted), else the inherited one."""
    name = element.attributes.get(key, inherited)
    if name in settings.defaults:
        return name
    notes.unknown(UNKNOWN_ENTITY, element.span, f"`{element.name}` has the class", name, settings.defaults)
    return inherited
