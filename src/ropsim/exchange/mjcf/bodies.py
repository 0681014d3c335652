"""Bodies of MJCF, which stand in each other, as bodies and connections by name."""

from dataclasses import replace

import numpy as np

from ropsim.exchange.assembly.description import Body, Connection, Motion
from ropsim.exchange.files.folder import RobotFolder
from ropsim.exchange.files.names import link_name
from ropsim.exchange.files.values import number_of, numbers_of
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.diagnostics import BAD_NUMBER, DOUBTFUL_BODY, ELEMENT_MISSING
from ropsim.exchange.losses.gathered import Topic
from ropsim.exchange.losses.loss_diagnostics import LOST_DESCRIPTION, LOST_MOTION
from ropsim.exchange.losses.notes import Notes
from ropsim.exchange.mjcf.defaults import MAIN
from ropsim.exchange.mjcf.free_bodies import coordinates_below, coordinates_of, free_base, frees, is_free
from ropsim.exchange.mjcf.geoms import Assets, Geometry, drawn, geometry_of
from ropsim.exchange.mjcf.joints import PlacedJoint, connection_of
from ropsim.exchange.mjcf.keywords import Keyword
from ropsim.exchange.mjcf.poses import pose_of
from ropsim.exchange.mjcf.settings import Settings, class_of
from ropsim.exchange.mjcf.weight_rules import corrected
from ropsim.model import Payload, combine, moved
from ropsim.spatial import Pose

WORLD = "world"
_KNOWN = {"body", "joint", "freejoint", "geom", "site", "inertial", "frame"}
_SILENT = {"light", "camera"}
_OTHERS = Topic(LOST_DESCRIPTION, "elements of bodies", "elements {} of bodies do not go over")
_FREE = Topic(
    LOST_MOTION,
    "free bodies",
    "bodies {} move about freely and are left out",
    "parts of a cell stand in its own file",
)
_FIXED_BASE = Topic(
    LOST_MOTION,
    "free base",
    "the base {} moves about freely in the file: it is taken as fixed",
    "a base that moves is a track or a carriage with joints of its own",
)
_MADE = Topic(
    LOST_MOTION,
    "bodies that are made",
    "elements {} make bodies or take them from other files, and are left out",
    "save the model by MuJoCo, which writes the bodies themselves",
)
_MAKERS = ("attach", "composite", "flexcomp")
_MESH_WEIGHT = Topic(
    DOUBTFUL_BODY,
    "weights of meshes",
    "bodies {} have the weight of a mesh, which is not computed",
    "write an inertial with its mass into them",
)

Part = tuple[Element, Pose, str]
"""An element of a body with its frame in that and its class."""


class BodyReader:
    """Bodies, connections and frames of one file, in order of the file.

    `places` has the place of each connection in the coordinates of MuJoCo (`qpos`), `coordinates` is their
    number; those of free bodies count.
    """

    def __init__(self, settings: Settings, assets: Assets, folder: RobotFolder, notes: Notes) -> None:
        self.bodies: list[Body] = []
        self.connections: list[Connection] = []
        self.frames: dict[str, tuple[str, Pose]] = {}
        self.free: list[str] = []
        self.places: dict[str, int] = {}
        self.coordinates = 0
        self._settings, self._assets, self._folder, self._notes = settings, assets, folder, notes
        self._others: dict[str, Element] = {}
        self._count = 0
        self._base: Element | None = None

    def read(self, world: Element) -> None:
        """Read all bodies of a world, each with its parent before it."""
        self._base = free_base(world, MAIN, self._settings)
        if self._base is not None:
            self._notes.gather(_FIXED_BASE, self._base.span, [self._base.attributes.get("name", "")])
        waiting: list[tuple[Element, str, Pose, str]] = [(world, "", Pose(), MAIN)]
        while waiting:
            element, parent, X, inherited = waiting.pop()
            if parent and element is not self._base and is_free(element, inherited, self._settings):
                self._leave(element, inherited)
                continue
            parts, X_BO = self._body(element, parent, X, inherited)
            name = self.bodies[-1].name
            children = [
                (one, name, X_BO @ at @ pose_of(one, self._settings, self._notes), own)
                for one, at, own in parts
                if one.name == "body"
            ]
            waiting += reversed(children)
        if self._others:
            self._notes.gather(_OTHERS, next(iter(self._others.values())).span, self._others)
        if self.free:
            self._notes.gather(_FREE, world.span, self.free)

    def _leave(self, element: Element, inherited: str) -> None:
        self.free.append(element.attributes.get("name", "without a name"))
        self.coordinates += coordinates_below(element, inherited, self._settings)

    def _body(self, element: Element, parent: str, X: Pose, inherited: str) -> tuple[list[Part], Pose]:
        """Read a body; return its elements with their frames and classes, and its own frame in its body."""
        settings, notes = self._settings, self._notes
        self._count += 1
        name = element.attributes.get("name", "").strip() or (f"body_{self._count}" if parent else WORLD)
        own = class_of(element, "childclass", inherited, settings, notes)
        parts = self._parts(element, own)
        X_BO = self._joints(parts, name, parent, X) if parent else Pose()
        geometry: list[Geometry] = []
        for one, at, inside in parts:
            if one.name == "geom":
                geom = self._whole(one, inside)
                made = geometry_of(geom, settings, self._assets, self._folder, notes)
                geometry.append(_shifted(made, X_BO @ at))
            elif one.name == "site" and "name" in one.attributes:
                site = self._whole(one, inside)
                self.frames[one.attributes["name"]] = name, X_BO @ at @ pose_of(site, settings, notes)
        weight = self._weight(element, name, parts, geometry, X_BO)
        self.bodies.append(Body(name, weight, drawn(geometry), element.span))
        return parts, X_BO

    def _whole(self, element: Element, inherited: str) -> Element:
        settings = self._settings
        name = class_of(element, "class", inherited, settings, self._notes)
        return settings.whole(element, name)

    def _parts(self, element: Element, inherited: str) -> list[Part]:
        """Return the elements of a body with their frames and classes, including `frame` contents."""
        found: list[Part] = []
        waiting = [(one, Pose(), inherited) for one in reversed(element.children)]
        while waiting:
            one, at, own = waiting.pop()
            if one.name == "frame":
                inner = at @ pose_of(one, self._settings, self._notes)
                name = class_of(one, "childclass", own, self._settings, self._notes)
                waiting += [(child, inner, name) for child in reversed(one.children)]
            elif one.name in _KNOWN:
                found.append((one, at, own))
            elif one.name in _MAKERS:
                self._notes.gather(_MADE, one.span, [one.name])
            elif one.name not in _SILENT:
                self._others.setdefault(one.name, one)
        return found

    def _joints(self, parts: list[Part], name: str, parent: str, X: Pose) -> Pose:
        """Connect a body by its joints, in their order; return its own frame in that of its last joint."""
        joints: list[tuple[PlacedJoint, int]] = []
        for one, at, own in parts:
            if one.name == "joint" and not frees(one, own, self._settings):
                joints.append((PlacedJoint(self._whole(one, own), at), self.coordinates))
            self.coordinates += coordinates_of(one, own, self._settings)
        if not joints:
            span = parts[0][0].span if parts else self.bodies[-1].span
            self.connections.append(Connection(f"{name}_mount", Motion.NONE, parent, name, X, span))
            return Pose()
        carrier = parent
        for place, (joint, coordinate) in enumerate(joints, start=1):
            called = joint.element.attributes.get("name", "").strip() or (
                f"{name}_joint" if len(joints) == 1 else f"{name}_joint_{place}"
            )
            child = name if place == len(joints) else link_name(called)
            ends = (carrier, child)
            self.connections.append(connection_of(joint, called, ends, X, self._settings, self._notes))
            self.places[called] = coordinate
            if child != name:
                self.bodies.append(Body(child, Payload(), (), joint.element.span))
            carrier, X = child, joint.anchor(self._notes).inverse()
        return X

    def _weight(
        self, element: Element, name: str, parts: list[Part], geometry: list[Geometry], X: Pose
    ) -> Payload:
        """Return the weight of a body: its own, else that of its geometry, as the settings say."""
        rules = self._settings.weights
        inertial, at = next(((one, at) for one, at, _ in parts if one.name == "inertial"), (None, X))
        if element.name == "worldbody":
            return Payload()
        heavy = [one for one in geometry if rules.has_mass(one.group)]
        if inertial is not None and (rules.from_geometry is not Keyword.TRUE or not heavy):
            return corrected(moved(inertial_of(inertial, self._settings, self._notes), X @ at), rules)
        if rules.from_geometry is Keyword.FALSE:
            return corrected(Payload(), rules)
        if any(one.weight is None for one in heavy):
            self._notes.gather(_MESH_WEIGHT, element.span, [name])
        return corrected(combine(tuple(one.weight for one in heavy if one.weight)), rules)


def _shifted(geometry: Geometry, X: Pose) -> Geometry:
    if X.is_identity:
        return geometry
    shapes = tuple(replace(one, pose=X @ one.pose) for one in geometry.shapes)
    weight = moved(geometry.weight, X) if geometry.weight else None
    return Geometry(shapes, weight, geometry.group)


def inertial_of(inertial: Element, settings: Settings, notes: Notes) -> Payload:
    """Return mass, centre of mass, and inertia about it, in the frame of the body."""
    X = pose_of(inertial, settings, notes)
    if "mass" not in inertial.attributes:
        notes.add(ELEMENT_MISSING, inertial.span, "an inertial has no mass", 'write mass="..." into it')
    mass = number_of(inertial, "mass", notes)
    if mass < 0.0:
        words = f"a body has a mass of {mass:g} kg, allowed is 0 kg or more"
        notes.add(BAD_NUMBER, inertial.span, words, "check the sign")
        return Payload()
    if "fullinertia" in inertial.attributes:
        xx, yy, zz, xy, xz, yz = numbers_of(inertial, "fullinertia", notes, (0.0,) * 6)
        inertia = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    else:
        inertia = np.diag(numbers_of(inertial, "diaginertia", notes, (0.0, 0.0, 0.0)))
    if X.orientation[0] == 1.0:
        return Payload(mass, X.position, inertia)
    return moved(Payload(mass, np.zeros(3), inertia), X)
