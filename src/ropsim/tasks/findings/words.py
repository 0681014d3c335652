"""The words of texts of tasks, for lists and for editors."""

from collections.abc import Mapping

from ropsim.tasks.kinds import SYMBOLIC, TYPES
from ropsim.tasks.terms.conditions import CONDITIONS, IN_ROWS

PROPERTIES: Mapping[str, str] = {
    "doc": "what the task is for",
    "params": "the kind of each variable of the head",
    "words": "what people call the variables, and a sentence on each",
    "range": "between which bounds the value of a variable is",
    "pre": "what must hold before",
    "eff": "what is true, or not true any more, afterwards",
    "geo": "what only geometry can tell",
    "body": "how it is done",
}
"""Properties of a task, with their meanings."""

STATEMENTS: Mapping[str, str] = {
    "mov": "mov(L)",
    "lin": "lin(L, [speed(V)])",
    "circ": "circ(Via, L)",
    "spline": "spline([A, B], L)",
    "open": "open",
    "close": "close",
    "wait": "wait(0.5*s)",
    "wait_until": "wait_until(signal, 2*s)",
    "set": "set(signal, on)",
    "load": "load([x, y, z], L)",
    "call": "call(task(L))",
    ":=": "x := x + A",
    "print": 'print(["…"])',
    "stop": 'stop("…")',
    "break": "break",
    "continue": "continue",
    "repeat": "repeat(N, [])",
    "repeat_until": "repeat_until(C, [])",
    "if": "if(C, [])",
    "while": "while(C, [])",
    "for": "for(i, 1, N, [])",
    "for_each": "for_each(q, pattern, [])",
    "with": "with([speed(V)], [])",
}
"""Statements of bodies, with an example of each; `shape/3` of kb.pl also has them."""

KINDS = (*sorted(SYMBOLIC), *TYPES)
"""Kinds of parameters."""

BLOCKS = ("repeat", "repeat_until", "if", "while", "for", "for_each", "with")
"""Statements that hold statements."""

FACTS = ("at", "free", "gripper", "held", "tool", "without_gripper", "follows", "part", "location", "device")
"""Names of the facts that cells have."""

OF_PATTERNS = ("enough", "filled", "vacant")
"""Conditions about the parts of a pattern; `pattern/1` of kb.pl also has them."""

GEOMETRY = (*CONDITIONS, IN_ROWS)
"""Conditions that geometry decides."""
