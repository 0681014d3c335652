"""A program object as the text that says it; every statement is told its line."""

from support.programs.nodes import Expr, Pattern, Program, Stmt, word

FRAMES = {
    "shelf": "(100, 50, 20; rz 90)",
    "tilted": "(-40, 30, 10; rx 30, rz 25) in pallet",
}
"""Frames that programs declare, beside `pallet` of the cell."""

_INFIX = frozenset(("+", "-", "*", "/", "mod", "=", "==", "<>", "<", "<=", ">", ">=", "and", "or"))
_DIMENSIONS = {
    "sin": "sin({} * 1 deg)",
    "cos": "cos({} * 1 deg)",
    "tan": "tan({} * 1 deg)",
    "asin": "(asin({}) / 1 rad)",
    "acos": "(acos({}) / 1 rad)",
    "atan2": "(atan2({}, {}) / 1 rad)",
    "per mm": "({} / 1 mm)",
    "as mm": "({} * 1 mm)",
    "more mm": "({} + {})",
}
"""Where a plain number becomes a quantity, or a quantity one."""
_ONE_LINE = ("then", "wait")
_CLOSERS = {
    "if": "endif",
    "while": "endw",
    "repeat": "endr",
    "for": "endf",
    "each": "endf",
    "with": "endwith",
}


def written(program: Program) -> str:
    """Return the text of a program."""
    lines = ["program made", "units mm, deg, s"]
    lines += ["classic"] if any(task.is_classic for task in program.tasks) else []
    lines += [f"frame {name} = {pose}" for name, pose in FRAMES.items()]
    lines += [
        f"const {name}: {word(one.kind)} = {expression(one)}" for name, one in program.constants.items()
    ]
    lines += [f"var {name}: {word(one.kind)} = {expression(one)}" for name, one in program.shared.items()]
    lines += [_pattern(one) for one in program.patterns]
    for task in program.tasks:
        parameters = ", ".join(
            f"{p.name}: {word(p.kind)}" + (f" = {expression(p.default)}" if p.default else "")
            for p in task.parameters
        )
        result = f" -> {word(task.result)}" if task.result else ""
        lines.append(f"task {task.name}" + ("" if task.is_classic else f"({parameters})") + result)
        _block(lines, task.body, 1)
        lines.append(_closer(lines, "endp"))
    _block(lines, program.main, 0)
    lines += [program.wrong[0]] if program.wrong else []
    return "\n".join(lines) + "\n"


def _pattern(one: Pattern) -> str:
    counts = " x ".join(map(str, one.counts))
    steps = ", ".join(map(str, one.steps))
    given = f"{one.first} in {one.frame}" if one.frame else str(one.first)
    return f"pattern {one.name} = grid {counts} from {given} step {steps} order {one.order}"


def _block(lines: list[str], block: list[Stmt], depth: int) -> None:
    for one in block:
        lines.append("  " * depth + _head(one))
        one.line, one.lines = len(lines), (len(lines),)
        if one.op in _ONE_LINE:
            _place_inner(one)
            continue
        for number, inner in enumerate(one.blocks):
            if number:
                condition = f"elseif {expression(one.parts[number])}" if number < len(one.parts) else "else"
                lines.append("  " * depth + condition)
                one.lines = (*one.lines, len(lines))
            _block(lines, inner, depth + 1)
        if one.op == "until":
            lines.append("  " * depth + f"until {expression(one.parts[-1])}")
            one.lines = (*one.lines, len(lines))
        elif one.op in _CLOSERS:
            lines.append("  " * depth + _closer(lines, _CLOSERS[one.op]))


def _place_inner(one: Stmt) -> None:
    """Note the line of the statements that stand on the line of another one."""
    for inner in (inner for block in one.blocks for inner in block):
        inner.line, inner.lines = one.line, one.lines
        _place_inner(inner)


def _closer(lines: list[str], long: str) -> str:
    """Return the closer of a block: on every other line the short one."""
    return long if len(lines) % 2 else "end"


def _head(one: Stmt) -> str:
    parts = [expression(part) for part in one.parts]
    arguments = ", ".join(
        f"{name} = {part}" if name else part for name, part in zip(one.names, parts, strict=False)
    )
    texts = {
        "assign": lambda: f"{one.name} = {parts[0]}",
        "component": lambda: f"{one.name}.{one.names[0]} = {parts[0]}",
        "load": lambda: f"load ({', '.join(one.names)}), {parts[0]}",
        "call": lambda: f"{one.name}({arguments})" if arguments else one.name,
        "plain call": lambda: f"call {one.name} {arguments}",
        "result": lambda: f"{one.names[-1]} = {one.name}({arguments})",
        "return": lambda: f"return {parts[0]}" if parts else "return",
        "print": lambda: f"print {', '.join(parts)}",
        "lin": lambda: f"lin {parts[0]}",
        "mov": lambda: f"mov {one.name}",
        "when": lambda: f"if {parts[0]} then {one.name}",
        "if": lambda: f"if {parts[0]}",
        "while": lambda: f"while {parts[0]}",
        "repeat": lambda: f"repeat {parts[0]}",
        "until": lambda: f"repeat {parts[0]}",
        "for": lambda: f"for {one.name} = {parts[0]} to {parts[1]} step {parts[2]}",
        "each": lambda: f"for each {one.name} in {one.names[0]}",
        "with": lambda: f"with {_settings(one)}",
        "setting": lambda: f"set {one.name} {parts[0]}",
        "loc": lambda: f"loc {one.name} = {parts[0]}",
        "then": lambda: f"if {parts[0]} then {_head(one.blocks[0][0])}",
        "wait": lambda: (
            f"wait until {parts[0]} timeout 10 ms"
            + (f" else {_head(one.blocks[0][0])}" if one.blocks else "")
        ),
        "set": lambda: f"set frame {one.name}",
    }
    return texts[one.op]() if one.op in texts else one.op


def _settings(one: Stmt) -> str:
    """Return the settings in the header of `with`."""
    frame = [f"frame {one.name}"] if one.name else []
    given = [f"{word} {expression(part)}" for word, part in zip(one.names, one.parts, strict=True)]
    return ", ".join([*frame, *given])


def expression(one: Expr) -> str:
    """Return the text of an expression, with parentheses around all that has operands."""
    parts = [expression(part) for part in one.parts]
    if one.op in ("literal", "name", "signal", "here", "reference"):
        return one.text
    if one.op in _INFIX:
        return f"({parts[0]} {one.op} {parts[1]})"
    if one.op in ("neg", "not"):
        return f"(-{parts[0]})" if one.op == "neg" else f"(not {parts[0]})"
    if one.op == "of":
        return f"{parts[0]}.{one.text}"
    if one.op in ("location", "polar", "like"):
        return f"({', '.join(parts[:3])}{_orientation(one, parts[3:])})"
    if one.op == "above":
        return f"({parts[0]} above {parts[1]})"
    if one.op in ("offset", "rel"):
        return f"({parts[0]} {one.op} ({', '.join(parts[1:])}))"
    if one.op == "in":
        return f"({parts[0]} in {one.text})"
    if one.op in _DIMENSIONS:
        return _DIMENSIONS[one.op].format(*parts)
    return f"{one.op}({', '.join(parts)})"


def _orientation(one: Expr, parts: list[str]) -> str:
    """Return what stands behind the three lengths of a location."""
    if one.op == "polar":
        return f", {parts[0]} * 1 deg, {parts[1]} * 1 deg"
    if one.op == "like":
        return f"; like {parts[0]}"
    return f"; {one.text} ({parts[0]} * 1 deg)" if parts else ""
