"""Locations with a turn about z alone, which points the tool up where most mean down."""

from ropsim.language.check.doubts import numerals
from ropsim.language.check.scope.body import Body
from ropsim.language.findings import types as kinds
from ropsim.language.report import OffsetRange
from ropsim.language.syntax import nodes
from ropsim.spatial import PoseTuple, quaternion

_UPRIGHT = 0.5
"""From this on the z of a frame points up in the world: the cosine of 60°."""


def check_target(body: Body, node: nodes.Node) -> None:
    """Warn of a location for the tool whose orientation is `rz` alone (T342).

    A step of `rel` or of a grid, a frame, and locations moved by `above`, `offset` and `rel` are not checked.
    """
    match node.operand if isinstance(node, nodes.External | nodes.Free) else node:
        case nodes.Tuple(turns=turns) as located if _turns_about_z(turns):
            _check(body, located, body.in_force.X_KC, body.in_force.moving)
        case nodes.Rebase(operand=nodes.Tuple(turns=turns) as located, frame=frame) if _turns_about_z(turns):
            _check(body, located, *body.frame(frame))


def _check(body: Body, node: nodes.Tuple, X_KF: PoseTuple, moving: str) -> None:
    if moving:
        return
    X_BF = quaternion.compose(body.world.X_BK, X_KF)
    frame_z_B = quaternion.rotate(X_BF[3:], (0.0, 0.0, 1.0))
    if sum(a * b for a, b in zip(frame_z_B, body.world.environment.up, strict=True)) < _UPRIGHT:
        return
    place = OffsetRange(node.turns[0].start, node.turns[-1].end)
    written = body.written(place)
    upright = f"rpy 0 0 0, {written}"
    if len(node.turns) == 1:
        upright = f"rpy 0 0 {body.written(node.turns[0].values[0])}"
    message = "`rz` alone points the tool up, along z of the frame; without terms `(x, y, z)` points down"
    hint = f"write `down, {written}`, or `{upright}` where up is meant"
    body.warn(kinds.POINTS_UP, place, message, hint, f"down, {written}")


def _turns_about_z(turns: tuple[nodes.Turn, ...]) -> bool:
    """Return whether terms are `rz`, and `rx` or `ry` of 0."""
    has_z = False
    for term in turns:
        if term.word == "rz":
            has_z = True
        elif term.word not in ("rx", "ry") or not _is_zero(term.values[0]):
            return False
    return has_z


def _is_zero(node: nodes.Node) -> bool:
    return numerals.bare(node) == 0.0 or (isinstance(node, nodes.Number) and node.value == 0.0)
