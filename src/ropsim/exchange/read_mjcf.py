"""MJCF becomes a robot."""

from dataclasses import replace

from ropsim.core import SourceText
from ropsim.exchange.assembly.description import Description
from ropsim.exchange.assembly.robot import read_robot
from ropsim.exchange.files.folder import STANDARD, ReadOptions
from ropsim.exchange.files.values import numbers_of
from ropsim.exchange.files.xml_tree import Element, read_xml
from ropsim.exchange.losses.diagnostics import ELEMENT_MISSING
from ropsim.exchange.losses.gathered import Topic, shown
from ropsim.exchange.losses.loss_diagnostics import LOST_DESCRIPTION, LOST_MOTION
from ropsim.exchange.losses.notes import Notes
from ropsim.exchange.mjcf.actuators import axis_names, driven
from ropsim.exchange.mjcf.attributes import check_attributes
from ropsim.exchange.mjcf.bodies import BodyReader
from ropsim.exchange.mjcf.constraints import coupled
from ropsim.exchange.mjcf.custom import limited
from ropsim.exchange.mjcf.geoms import assets_of
from ropsim.exchange.mjcf.includes import with_included
from ropsim.exchange.mjcf.key_frames import home_of
from ropsim.exchange.mjcf.keywords import Keyword, switch_of
from ropsim.exchange.mjcf.replicas import with_replicas
from ropsim.exchange.mjcf.settings import settings_of
from ropsim.exchange.mjcf.weight_rules import scaled_to_total
from ropsim.exchange.xacro.expansion import refuse_arguments
from ropsim.model import ReadRobot

_SILENT = frozenset(
    (
        *("compiler", "option", "default", "asset", "worldbody", "equality", "actuator", "keyframe"),
        *("custom", "visual", "statistic", "size", "contact"),
    )
)
_TENDONS = Topic(LOST_MOTION, "tendons", "tendons {} do not go over")
_OTHERS = Topic(LOST_DESCRIPTION, "elements for other programs", "elements {} do not go over")


def read_mjcf(source: SourceText, options: ReadOptions = STANDARD) -> ReadRobot:
    """Return the robot of an MJCF file.

    The file is read as the XML reference of MuJoCo 4 defines it: defaults by class, angles in the unit of the
    compiler, joints about points of bodies, weights of geometry where a body says none. Bodies that are fixed
    to each other become one; the chain to the tip, a body or a site, becomes the arm; bodies that move about
    freely are left out. The axes come in the order of their actuators.

    Args:
        source: the file.
        options: tip and folders.
    """
    notes = Notes()
    root = read_xml(source, notes)
    refuse_arguments(options, source, notes)
    whole = with_included(root, options.folder, notes) if root else None
    description = _description(whole, options, notes) if whole else None
    made = read_robot(description, options.tip, source, notes)
    return replace(made, files=options.folder.files)


def _description(root: Element, options: ReadOptions, notes: Notes) -> Description | None:
    if root.name != "mujoco":
        words = f"the outermost element is `{shown(root.name)}`, that of MJCF is `mujoco`"
        notes.add(ELEMENT_MISSING, root.span, words, "is it a file of another format?")
        return None
    settings = settings_of(root, notes)
    reader = BodyReader(settings, assets_of(root, settings), options.folder, notes)
    if root.first("worldbody") is None:
        notes.add(ELEMENT_MISSING, root.span, "the file has no `worldbody`", "bodies stand in it")
        return None
    whole = with_replicas(root, settings, notes)
    if whole is None:
        return None
    check_attributes(root, notes)
    reader.read(whole.children[0])
    connections = driven(coupled(reader.connections, whole, notes), whole, settings, notes)
    axes = axis_names(connections, whole)
    connections = limited(connections, axes, root, notes)
    _losses(root, notes)
    return Description(
        root.attributes.get("model", "").strip() or "robot",
        scaled_to_total(reader.bodies, settings.weights),
        connections,
        root.span,
        gravity=_gravity(root, notes),
        home=home_of(root, connections, reader.places, reader.coordinates, notes),
        axes=axes,
        frames=reader.frames,
    )


def _gravity(root: Element, notes: Notes) -> tuple[float, float, float]:
    """Return the acceleration of free fall [m/s²]; zero where a flag disables it."""
    gravity = (0.0, 0.0, -9.81)
    falls = Keyword.ENABLE
    for option in root.all("option"):
        x, y, z = numbers_of(option, "gravity", notes, gravity)
        gravity = (x, y, z)
        for flag in option.all("flag"):
            falls = switch_of(flag, "gravity", notes, falls)
    return gravity if falls is Keyword.ENABLE else (0.0, 0.0, 0.0)


def _losses(root: Element, notes: Notes) -> None:
    tendons = [one for tendon in root.all("tendon") for one in tendon.children]
    if tendons:
        notes.gather(_TENDONS, tendons[0].span, (one.attributes.get("name", one.name) for one in tendons))
    others = [one for one in root.children if one.name not in _SILENT and one.name != "tendon"]
    if others:
        notes.gather(_OTHERS, others[0].span, (one.name for one in others))
