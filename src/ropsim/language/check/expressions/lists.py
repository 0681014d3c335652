"""Points of a list by number or name: `seam[3]`, `rack["p7"]`."""

from ropsim.core import did_you_mean
from ropsim.language.check.expressions import frames, values
from ropsim.language.check.scope import fold
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import INT, Value
from ropsim.language.check.scope.world import Listed, Poison
from ropsim.language.findings import names as name_kinds
from ropsim.language.findings import syntax as syntax_kinds
from ropsim.language.findings import types as kinds
from ropsim.language.report import OffsetRange
from ropsim.language.syntax import nodes
from ropsim.program import Expression


def indexed(body: Body, node: nodes.Index) -> Value:
    """Return `list[number]` or `list["name"]`.

    Raises:
        RejectedError: the operand is no list, or it has no such point.
    """
    name = node.operand
    symbol = body.find(name.text) if isinstance(name, nodes.Name) else None
    if isinstance(symbol, Listed) and isinstance(name, nodes.Name):
        body.with_points(symbol, name)
        return frames.listed_point(body, symbol, _number(body, symbol, node.index))
    if symbol is None or isinstance(symbol, Poison):
        values.check(body, node.operand)  # reports a name that is not known
    body.fail(
        syntax_kinds.NOT_YET,
        OffsetRange(node.opening, node.opening + 1),
        "`name[index]` is not yet in this version, except for lists of points",
        "see `ropsim explain L109`; leave it out or use the statements that exist",
    )


def _number(body: Body, listed: Listed, node: nodes.Node) -> Expression:
    """Return the number of a point, from 1; a constant one is in range.

    Raises:
        RejectedError: it is not, or the list has no point of the name.
    """
    if isinstance(node, nodes.Text):
        number = listed.table.names.get(node.value)
        if number is None:
            message = f"`{listed.name}` has no point `{node.value}`"
            hint = (
                did_you_mean(node.value, listed.table.names)
                or "the names stand in the first column of the list"
            )
            body.fail(name_kinds.UNKNOWN_POINT, node, message, hint)
        return fold.whole(number)
    index = values.expect(body, node, INT, f"the number of a point of `{listed.name}`")
    found, count = fold.number_of(index), len(listed.table.points)
    if found is not None and not 1 <= found <= count:
        message = f"`{listed.name}` has the points 1 to {count}, found {found:g}"
        body.fail(kinds.OUT_OF_RANGE, node, message, "points are counted from 1")
    return index
