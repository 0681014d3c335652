"""The walk through a body: lines to statements, blocks to one structured statement each."""

from collections.abc import Iterable
from contextlib import nullcontext

from ropsim.language.blocks.matching import Block as SyntaxBlock
from ropsim.language.blocks.matching import Section
from ropsim.language.check.expressions import frames, values
from ropsim.language.check.scope.body import Body, Loop, RejectedError
from ropsim.language.check.scope.types import BOOL
from ropsim.language.check.statements import lines, loops, never_run, settings
from ropsim.language.check.statements.silent import tells_nothing
from ropsim.language.findings import syntax as kinds
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.line import parse_line
from ropsim.language.syntax.text import Line
from ropsim.program import Block, If, Repeat, Statement, With
from ropsim.program import For as ForStatement


def walk(body: Body, items: Iterable[Line | SyntaxBlock]) -> Block:
    """Return the statements of a body; wrong ones are reported and left out.

    A `set frame` holds up to the end of these items.
    """
    with frames.in_block(body):
        return walk_part(body, items)


def walk_part(body: Body, items: Iterable[Line | SyntaxBlock]) -> Block:
    """Return the statements of a part of a body; a `set frame` holds on behind it."""
    body.depth += 1
    is_silent = body.report.muted
    result: list[Statement] = []
    for item in items:
        line = item.opener if isinstance(item, SyntaxBlock) else item
        if is_silent and line is item and tells_nothing(body, line):
            continue
        body.line = line
        try:
            result.extend(
                _block(body, item) if isinstance(item, SyntaxBlock) else lines.statement(body, line.statement)
            )
        except RejectedError:
            body.in_force.is_read = True  # the frame that the line would have read is unknown
            body.has_gaps |= isinstance(line.statement, syntax.Return | syntax.Call)
            lines.poison_targets(body, line.statement)
    body.depth -= 1
    return tuple(result)


def _block(body: Body, tree: SyntaxBlock) -> Block:
    """Return the structured statement of a block; where its header is wrong its lines are still checked."""
    first = tree.sections[0]
    node = first.header.statement
    _poison_dropped(body, tree.sections)
    try:
        match node:
            case syntax.If():
                return _if(body, tree)
            case syntax.While():
                condition = loops.while_condition(body, node)
                never_run.check_condition(body, node, node.condition, condition)
                inner = _loop_body(body, first)
                body.line = first.header
                return loops.while_loop(body, condition, inner)
            case syntax.Repeat():
                return _repeat(body, tree, node)
            case syntax.For():
                return _for(body, first, node)
            case syntax.ForEach():
                return loops.for_each(body, node, lambda: _walk_then_return_to(body, first))
            case syntax.With():
                return _with(body, first, node)
    except RejectedError:
        lines.poison_targets(body, node)
    return _only_checked(body, tree)


def _poison_dropped(body: Body, sections: Iterable[Section]) -> None:
    """Mark names made by statements on header lines: these statements are wrong and left out."""
    for header in (section.header for section in sections):
        if header.fault is None:
            continue
        body.has_gaps = True
        dropped, fault = parse_line(header.logical.text[header.fault.start :])
        if fault is None:
            lines.poison_targets(body, dropped)


def _only_checked(body: Body, tree: SyntaxBlock) -> Block:
    """Check the lines under a header that is wrong, as if they stood in a loop; they are left out."""
    body.has_gaps = True
    lines.poison_targets(body, tree.opener.statement)
    with body.in_loop(Loop()):
        for section in tree.sections:
            walk(body, section.body)
    return ()


def _if(body: Body, tree: SyntaxBlock) -> Block:
    branches, places = [], []
    otherwise: Block = ()
    is_decided = False
    for number, section in enumerate(tree.sections):
        body.line = section.header
        node = section.header.statement
        if is_decided and node is not None:
            never_run.check_other(body, node)
        if isinstance(node, syntax.If | syntax.ElseIf):
            try:
                condition = values.expect(
                    body, node.condition, BOOL, f"the condition of `{section.header.head}`"
                )
            except RejectedError:
                body.has_gaps = True
                walk(body, section.body)
                continue
            if not is_decided:
                never_run.check_condition(body, node, node.condition, condition)
            is_decided = is_decided or never_run.is_always_true(body, node.condition, condition)
            places.append(body.statement_span)
            branches.append((condition, walk(body, section.body)))
        else:
            if isinstance(node, syntax.Else) and number != len(tree.sections) - 1:
                body.report.line(
                    kinds.MISPLACED, section.header, "`else` before another branch", "make it the last branch"
                )
            otherwise = walk(body, section.body)
    body.line = tree.opener
    if not branches:
        return ()
    return (If(tuple(branches), otherwise, body.statement_span, tuple(places[1:] and places)),)


def _repeat(body: Body, tree: SyntaxBlock, node: syntax.Repeat) -> Block:
    first = tree.sections[0]
    count = loops.count_of(body, node)
    never_run.check_count(body, node, count)
    inner = _loop_body(body, first)
    until, place = None, None
    closer = tree.closer
    if closer is not None and isinstance(closer.statement, syntax.Until):
        body.line = closer
        try:
            until = values.expect(body, closer.statement.condition, BOOL, "the condition of `until`")
            place = body.statement_span
        except RejectedError:
            return ()
    body.line = first.header
    return (Repeat(count, inner, until, body.statement_span, place),)


def _for(body: Body, section: Section, node: syntax.For) -> Block:
    variable, first, last, step = loops.for_header(body, node)
    never_run.check_way(body, node, first, last, step)
    name = node.name.text
    scope = nullcontext() if body.find(name) is variable else body.with_name(name, variable)
    with scope, body.in_loop(Loop(variable=variable.name)):
        inner = walk(body, section.body)
    body.line = section.header
    return (ForStatement(variable.name, first, last, step, inner, body.statement_span),)


def _with(body: Body, section: Section, node: syntax.With) -> Block:
    chosen = settings.gather(body, node.settings)
    here = body.in_force.X_KC, body.in_force.moving
    named = next((one.name for one in node.settings if one.word == "frame" and one.name is not None), None)
    with frames.in_frame(body, *(body.frame(named) if named is not None else here)):
        inner = walk(body, section.body)
    body.line = section.header
    return (With(chosen, inner, body.statement_span),)


def _loop_body(body: Body, section: Section) -> Block:
    with body.in_loop(Loop()):
        return walk(body, section.body)


def _walk_then_return_to(body: Body, section: Section) -> Block:
    inner = walk(body, section.body)
    body.line = section.header
    return inner
