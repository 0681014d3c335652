"""Motions in plain numbers: no name in them can get a type, so the walk that finds types passes them by."""

from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax


def is_literal(statement: syntax.Statement | None) -> bool:
    """Return whether a statement is a motion to a place in numbers and does nothing else."""
    if type(statement) is not syntax.Motion:
        return False
    target = statement.target
    return (
        type(target) is nodes.Tuple
        and not (statement.via or statement.triggers or statement.condition or statement.timeout)
        and statement.store is None
        and statement.tracking is None
        and target.posture is None
        and all(_is_number(one.value) for one in target.items)
        and all(one.like is None and all(map(_is_number, one.values)) for one in target.turns)
        and all(one.value is not None and _is_number(one.value) for one in statement.modifiers)
    )


def _is_number(node: nodes.Node) -> bool:
    if type(node) is nodes.Unary:
        node = node.operand
    return type(node) is nodes.Number
