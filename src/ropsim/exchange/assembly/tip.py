"""Which link of a robot file carries the tool."""

from collections.abc import Mapping, Sequence

from ropsim.core import frozen_dataclass
from ropsim.exchange.assembly.description import Description
from ropsim.exchange.assembly.ends import axes_before, ends_of, last_carrier
from ropsim.exchange.assembly.link_tree import LinkTree
from ropsim.exchange.losses.diagnostics import TIP_UNCLEAR, UNKNOWN_ENTITY
from ropsim.exchange.losses.gathered import listed
from ropsim.exchange.losses.notes import Notes
from ropsim.model import REQUEST, Tip
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


@frozen_dataclass
class ChosenTip:
    """The tip of a robot file.

    Attributes:
        tip: its name, and why it was chosen.
        body: the body that carries it.
        X_CM: interface in the frame of the body.
    """

    tip: Tip
    body: str
    X_CM: Pose


_Known = Mapping[str, tuple[str, Pose]]


def tip_of(description: Description, tree: LinkTree, wanted: str | None, notes: Notes) -> ChosenTip | None:
    """Return the link or frame that is the tip; nothing where that is unclear (noted).

    It is the one that is requested, else the one with a usual name, else the end of the
    arm with most axes, see `ends_of`.
    """
    known = dict(description.frames) | {one.name: (one.name, Pose()) for one in description.bodies}
    if wanted is not None:
        if wanted not in known:
            asked = {REQUEST: ("tip",)}
            notes.unknown(UNKNOWN_ENTITY, description.span, "the tip is to be", wanted, known, asked)
            return None
        return ChosenTip(Tip(wanted, "as requested"), *known[wanted])
    usual = _usual(known, tree)
    if len(usual) == 1:
        return ChosenTip(Tip(usual[0], "its name is usual"), *known[usual[0]])
    ends = ends_of(tree, {one.name: one for one in description.bodies})
    if usual or len(ends) > 1:
        _unclear(description, usual or _with_carrier([one.body for one in ends], tree), notes)
        return None
    end = ends[0]
    reason = "axes behind it move fingers" if end.is_hand else "it is the end with most axes before it"
    return ChosenTip(Tip(end.body, reason), end.body, Pose())


def _usual(known: _Known, tree: LinkTree) -> list[str]:
    """Return the names for the first usual word that some moved links have.

    The exact name comes first, then the names that end with the word and have most axes before them.
    """
    axes = {name: axes_before(tree, body) for name, (body, _) in known.items()}
    moved = [name for name, count in axes.items() if count]
    for usual in USUAL_TIPS:
        exact = [name for name in moved if name.lower() == usual]
        found = [name for name in moved if name.lower().endswith(("_" + usual, "/" + usual, "-" + usual))]
        if exact or found:
            most = max((axes[name] for name in found), default=0)
            return exact or [name for name in found if axes[name] == most]
    return []


def _with_carrier(ends: list[str], tree: LinkTree) -> list[str]:
    """Return ends behind the last link that carries all of them, if more axes are before it than behind.

    So the palm of a hand is offered, and the torso of two arms is not.
    """
    carrier = last_carrier(ends, tree)
    before = axes_before(tree, carrier)
    behind = max(axes_before(tree, one) for one in ends) - before
    return [carrier, *ends] if carrier not in ends and before > behind else ends


def _unclear(description: Description, ends: Sequence[str], notes: Notes) -> None:
    words = f"{len(ends)} links can carry the tool: {listed(ends)}"
    hint = f'choose one: `--tip {ends[0]}`, or in a cell file `tip = "{ends[0]}"`'
    notes.add(TIP_UNCLEAR, description.span, words, hint, {"ends": tuple(ends), REQUEST: ("tip",)})
