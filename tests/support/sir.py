"""The structured program as text, for golden files: one statement per line with its source line."""

from dataclasses import fields
from enum import Enum

from ropsim.core import Span
from ropsim.flow import PostureRequest, TargetOrientation
from ropsim.program import (
    Binary,
    Component,
    Constant,
    Guard,
    InAxes,
    InPosture,
    Keeping,
    MakeExternal,
    MakeJoints,
    MakePose,
    MakeVector,
    MakeZyx,
    Offset,
    Program,
    Settings,
    SignalValue,
    Statement,
    Trigger,
    Unary,
    Variable,
)


def render(program: Program) -> str:
    """Return the program as text; numbers with twelve digits, so that the last bit does not matter."""
    lines = [f"program {program.name} frame={program.frame or '-'}"]
    lines += [f"signal {s.name} {'in' if s.is_input else 'out'} {s.type.value}" for s in program.signals]
    for task in program.tasks:
        parameters = ", ".join(f"{p.name} {p.type.value}" for p in task.parameters)
        lines.append(f"task {task.name}({parameters}) -> {task.result.value if task.result else '-'}")
        lines += [f"  local {v.name} {v.type.value}" for v in task.locals]
        lines += [f"  needs {c.gripper.value if c.gripper else '-'} {c.text!r}" for c in task.contracts]
        lines += _block(task.body, 1)
    lines.append("main")
    lines += [f"  local {v.name} {v.type.value}" for v in program.main_locals]
    lines += _block(program.main, 1)
    return "\n".join(lines) + "\n"


def _block(block: tuple[Statement, ...], depth: int) -> list[str]:
    lines: list[str] = []
    for statement in block:
        parts, inner = [], []
        for field in fields(statement):
            value = getattr(statement, field.name)
            if isinstance(value, Span) or field.name == "places":
                continue
            if field.name in ("body", "otherwise") and value:
                inner += [f"{'  ' * depth}  {field.name}:", *_block(value, depth + 2)]
            elif field.name == "branches":
                for condition, branch in value:
                    inner += [f"{'  ' * depth}  if {_text(condition)}:", *_block(branch, depth + 2)]
            elif value not in (None, "", ()):
                parts.append(f"{field.name}={_text(value)}")
        head = type(statement).__name__.lower()
        lines.append(f"{'  ' * depth}{statement.span.line}: {head} {' '.join(parts)}".rstrip())
        lines += inner
    return lines


def _text(value: object) -> str:
    match value:
        case Constant(value=content):
            text = f"({_text(content)})" if isinstance(content, tuple) else _text(content)
        case Variable(name=name) | SignalValue(name=name):
            text = name
        case Unary(op=op, operand=operand):
            text = f"{op}[{_text(operand)}]"
        case Binary(op=op, left=left, right=right):
            text = f"{op}[{_text(left)}, {_text(right)}]"
        case Component(operand=operand, index=index):
            text = f"{_text(operand)}.{index}"
        case MakeVector() | MakeZyx() | MakePose() | MakeExternal() | MakeJoints():
            parts = [_text(getattr(value, f.name)) for f in fields(value) if f.name != "type"]
            text = f"{type(value).__name__.lower()}[{', '.join(parts)}]"
        case Keeping():
            text = f"keeping[{_text(value.value)}, {_text(value.result)}]"
        case PostureRequest():
            text = f"{'-'.join(value.words) or 'any'} turns {list(value.turns)}"
            text += " free" if value.orientation is TargetOrientation.FREE else ""
        case InAxes(operand=operand, axes=axes):
            text = f"in_axes[{_text(operand)}, ({_text(axes)})]"
        case Offset(operand=operand, way=way):
            text = f"offset[{_text(operand)}, {_text(way)}]"
        case InPosture():
            text = f"in_posture[{_text(value.operand)}, {_text(value.request)}]"
        case Trigger() | Guard():
            given = [(f.name, getattr(value, f.name)) for f in fields(value)]
            text = "(" + " ".join(f"{n}={_text(v)}" for n, v in given if v is not None) + ")"
        case Settings():
            given = [(f.name, getattr(value, f.name)) for f in fields(value)]
            text = "{" + ", ".join(f"{n} {_text(v)}" for n, v in given if v is not None) + "}"
        case _:
            text = _plain(value)
    return text


def _plain(value: object) -> str:
    match value:
        case bool() | str():
            return str(value)
        case int() | float():
            return f"{value:.12g}" if abs(value) > 1e-15 else "0"
        case Enum():
            return str(value.value)
        case tuple():
            return " ".join(_text(v) for v in value)
    return type(value).__name__.lower()
