"""Which body of a tree carries the tool."""

from ropsim.exchange.assembly.description import Description, Motion
from ropsim.exchange.assembly.link_tree import LinkTree
from ropsim.exchange.losses.diagnostics import TIP_UNCLEAR, UNKNOWN_ENTITY
from ropsim.exchange.losses.notes import Notes, listed
from ropsim.spatial import Pose

USUAL_TIPS = (
    "tool0",
    "flange",
    "attachment_site",
    "hand_tcp",
    "tcp",
    "ee_link",
    "tool_frame",
    "ee_site",
    "end_effector",
)
"""Names of the mechanical interface in robot files, with a prefix or without (REP 199, makers' files)."""


def tip_of(
    description: Description, tree: LinkTree, wanted: str | None, notes: Notes
) -> tuple[str, Pose] | None:
    """Return the body that is the tip, and the interface in its frame; nothing where that is unclear (noted).

    It is the body or frame that is requested, else the only one with a usual name, else the end behind the
    most joints; where several ends are fixed to the last of these, the body that it moves.
    """
    known = dict(description.frames) | {one.name: (one.name, Pose()) for one in description.bodies}
    if wanted is not None:
        if wanted not in known:
            notes.unknown(UNKNOWN_ENTITY, description.span, "the tip is to be", wanted, known)
        return known.get(wanted)
    for usual in USUAL_TIPS:
        found = [name for name in known if name == usual or name.endswith(("_" + usual, "/" + usual))]
        if len(found) == 1:
            return known[found[0]]
    end = _deepest(description, tree, notes)
    return (end, Pose()) if end else None


def _deepest(description: Description, tree: LinkTree, notes: Notes) -> str | None:
    depth, last = {tree.root: 0}, {tree.root: tree.root}
    for one in tree.order:
        moves = one.motion is not Motion.NONE and one.following is None
        depth[one.child] = depth[one.parent] + moves
        last[one.child] = one.child if moves else last[one.parent]
    parents = {one.parent for one in tree.order}
    most = max(depth.values())
    ends = [name for name in depth if depth[name] == most and name not in parents]
    behind = {last[name] for name in ends}
    if len(ends) == 1:
        return ends[0]
    if len(behind) == 1:
        return behind.pop()
    notes.add(
        TIP_UNCLEAR,
        description.span,
        f"{len(ends)} ends have {most} joints before them: {listed(ends)}",
        f"name the tip: allowed are {listed(ends)}",
        {"ends": tuple(ends)},
    )
    return None
