"""URDF, and xacro that makes it, become a robot."""

from collections.abc import Sequence
from dataclasses import replace

from ropsim.core import SourceText
from ropsim.exchange.assembly.description import Body, Connection, Description
from ropsim.exchange.assembly.robot import read_robot
from ropsim.exchange.files.folder import STANDARD, ReadOptions
from ropsim.exchange.files.xml_tree import Element, read_xml
from ropsim.exchange.losses.diagnostics import ELEMENT_MISSING
from ropsim.exchange.losses.gathered import Topic, shown
from ropsim.exchange.losses.loss_diagnostics import LOST_DESCRIPTION
from ropsim.exchange.losses.notes import Notes
from ropsim.exchange.urdf.attributes import check_attributes
from ropsim.exchange.urdf.joints import connection_of, lost_of
from ropsim.exchange.urdf.links import body_of
from ropsim.exchange.urdf.shapes import materials_of
from ropsim.exchange.xacro.callers import macros_of, note_macros
from ropsim.exchange.xacro.expansion import expanded, refuse_arguments, uses_xacro
from ropsim.model import Payload, ReadRobot

_WORLD = "world"
_READ = {"link", "joint", "material"}
_OTHERS = Topic(
    LOST_DESCRIPTION, "elements for other programs", "elements {} for other programs do not go over"
)


def read_urdf(source: SourceText, options: ReadOptions = STANDARD) -> ReadRobot:
    """Return the robot of a URDF or xacro file.

    The file is read as version 1.2 of the format defines it. Links that are fixed to each other become one;
    the chain to the tip and joints coupled to it become joints of the model; see X993 for the others.

    Args:
        source: the file.
        options: tip, folders and arguments.
    """
    notes = Notes()
    root = read_xml(source, notes)
    if root and uses_xacro(root):
        whole = expanded(root, options, notes)
        if whole and not whole.first("link") and macros_of(root):
            note_macros(root, options.folder, notes)
            whole = None
    else:
        whole = root
        refuse_arguments(options, source, notes)
    description = _description(whole, options, notes) if whole else None
    made = read_robot(description, options.tip, source, notes)
    return replace(made, files=options.folder.files)


def _description(root: Element, options: ReadOptions, notes: Notes) -> Description | None:
    if root.name != "robot":
        words = f"the outermost element is `{shown(root.name)}`, that of URDF is `robot`"
        notes.add(ELEMENT_MISSING, root.span, words, "is it a file of another format?")
        return None
    if root.first("group") and not root.first("link"):
        words = "the file has groups of links for MoveIt (SRDF), and no links"
        notes.add(
            ELEMENT_MISSING, root.span, words, "the robot stands in the URDF or xacro file of its package"
        )
        return None
    materials = materials_of(root, notes)
    read = (body_of(one, materials, options.folder, notes) for one in root.all("link"))
    connections = [connection_of(one, notes) for one in root.all("joint")]
    bodies = [one for one in read if one]
    if _hangs_on_world(bodies, connections):
        bodies.insert(0, Body(_WORLD, Payload(), (), root.span))
    _losses(root, notes)
    return Description(
        root.attributes.get("name", "").strip() or "robot",
        tuple(bodies),
        tuple(one for one in connections if one),
        root.span,
    )


def _hangs_on_world(bodies: Sequence[Body], connections: Sequence[Connection | None]) -> bool:
    """Return whether the parent of a joint is the ground without a link, which simulators accept."""
    is_link = any(one.name == _WORLD for one in bodies)
    return not is_link and any(one is not None and one.parent == _WORLD for one in connections)


def _losses(root: Element, notes: Notes) -> None:
    check_attributes(root, notes)
    for joint in root.all("joint"):
        lost_of(joint, notes)
    others = [one for one in root.children if one.name not in _READ]
    if others:
        notes.gather(_OTHERS, others[0].span, (one.name for one in others))
