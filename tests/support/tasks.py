"""Compiling in tests: a small cell, and findings as text."""

from ropsim.core import Diagnostic
from ropsim.language import Compiled, Environment, compile
from ropsim.program import SignalUse, ValueType

CELL = Environment(
    frames={"pallet": (0.4, -0.3, 0.0, 1.0, 0.0, 0.0, 0.0)},
    tools={"jaws": (0.0, 0.0, 0.145, 1.0, 0.0, 0.0, 0.0)},
    default_tool="jaws",
    locations={"infeed": (0.4, 0.3, 0.1, 0.0, 1.0, 0.0, 0.0)},
    signals={"part_ok": SignalUse("part_ok", is_input=True, type=ValueType.BOOL)},
)
"""Location `infeed`, frame `pallet`, tool `jaws`, input `part_ok`."""


def compiled(text: str, environment: Environment = CELL) -> Compiled:
    """Compile a text in the small cell."""
    return compile(text, environment, "t.task")


def codes(text: str, environment: Environment = CELL) -> list[str]:
    """Return the codes of all findings in order."""
    return [d.code for d in compiled(text, environment).diagnostics]


def only(text: str, environment: Environment = CELL) -> Diagnostic:
    """Return the one finding of a text."""
    found = compiled(text, environment).diagnostics
    assert len(found) == 1, [str(d) for d in found]
    return found[0]


def findings(result: Compiled) -> str:
    """Return all findings as text, each with the marked part of its line and the hint."""
    lines = []
    for finding in result.diagnostics:
        lines.append(str(finding))
        span = finding.span
        if span is not None and span.line == span.end_line:
            lines.append(f"  marked: {result.source.line(span.line)[span.column - 1 : span.end_column - 1]}")
        if finding.hint:
            lines.append(f"  hint: {finding.hint}")
    return "\n".join(lines) + "\n" if lines else "no findings\n"
