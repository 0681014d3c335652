"""Words and signs of other languages, and their equivalents here."""

import re
from collections.abc import Mapping

_LIN = "did you mean `lin`? speed and zone stand behind the target: `lin p speed 500 mm/s blend 10 mm`"
_MOV = "did you mean `mov`? speed and zone stand behind the target: `mov p speed 50 % blend 10 mm`"
_MOVE = "a straight line is `lin p`, a way of the joints `mov p`"
_JUMP = "a way over what stands between has its own moves: `lin here above 60`, `mov p above 60`, `lin p`"
_JOINTS = "joint coordinates are a target of `mov`: write `mov joints(…)`"
_CIRCLE = "a circular move names its point on the way first: write `circ via a to b`"
_TRIGGER = "outputs are set on the way of a motion: write `lin p at 3 mm after start do set NAME on`"
_SEARCH = "a motion ends by a condition: write `lin p until NAME store q`"
_SET = "outputs are set by name: write `set NAME on`, `set NAME off` or `set NAME = value`"
_RESET = "outputs are set by name: write `set NAME off`"
_WAIT_UNTIL = "inputs are read by name: write `wait until NAME`"
_WAIT_TIME = "a wait says its time with a unit: write `wait 0.5 s`"

_TASK = "a task begins with `task Name(parameter: type)` and ends with `endp`"
_CLOSER = (
    "a block ends with `end` alone on its line, or with an end of its own: "
    "`endif`, `endw`, `endr`, `endf`, `endwith`, `endp`"
)
_LOOP = "loops are `repeat 3 … endr`, `while … endw`, `for i = 1 to 3 … endf`; `repeat` alone has no end"
_CHOICE = "write `if … elseif … else … endif`"
_STOP = "the end of a program is `stop`, the way out of a task `return`, out of a loop `break`"
_DECLARED = "a variable is made by its first value, `x = 3`, or by `var x: type`"
_MODAL = "settings stand behind `set` or a target: `set speed 500 mm/s`, `lin p speed 500 mm/s`"
_NEXT = "a `for` ends with `endf`"
_GRIPPER = "the gripper is opened and closed by `open` and `close`"

ENDS: Mapping[str, str] = {
    **dict.fromkeys(("endproc", "endprocedure", "endfunc", "endfunction", "endsub", "enddef"), "endp"),
    **dict.fromkeys(("endwhile", "wend"), "endw"),
    **dict.fromkeys(("endfor", "endforeach"), "endf"),
    **dict.fromkeys(("endswitch", "endselect", "endcase", "fi"), "endif"),
    "endrepeat": "endr",
    **dict.fromkeys(("endloop", "endblock"), "end"),
}
"""Words that end blocks elsewhere, alone on a line, and their equivalents here."""

END_OF_PROGRAM = "a program ends with its last line: leave this one out"
"""Hint for the end of a program or module."""

HINTS: Mapping[str, str] = {
    "movel": _LIN,
    "moves": _LIN,
    "slin": _LIN,
    "movej": _MOV,
    "ptp": _MOV,
    "sptp": _MOV,
    **dict.fromkeys(("linear", "movep", "lmove", "moveline"), _LIN),
    **dict.fromkeys(("moveto", "joint", "jmove", "movejoint"), _MOV),
    "moveabsj": _JOINTS,
    "movec": _CIRCLE,
    "scirc": _CIRCLE,
    **dict.fromkeys(("circular", "circle"), _CIRCLE),
    "triggio": _TRIGGER,
    "triggl": _TRIGGER,
    "triggj": _TRIGGER,
    "trigger": _TRIGGER,
    "searchl": _SEARCH,
    "searchj": _SEARCH,
    "setdo": _SET,
    "setgo": _SET,
    "setao": _SET,
    "set_digital_out": _SET,
    "set_standard_digital_out": _SET,
    "reset": _RESET,
    "waitdi": _WAIT_UNTIL,
    "waituntil": _WAIT_UNTIL,
    "waittime": _WAIT_TIME,
    "sleep": _WAIT_TIME,
    "delay": _WAIT_TIME,
    "pause": _WAIT_TIME,
    "go": _MOV,
    "move": _MOVE,
    "jump": _JUMP,
    "arc": _CIRCLE,
    "gripper": _GRIPPER,
    "grasp": _GRIPPER,
    "def": _TASK,
    "proc": _TASK,
    "procedure": _TASK,
    "function": _TASK,
    "func": _TASK,
    "sub": _TASK,
    **dict.fromkeys(("endmodule", "endprogram"), END_OF_PROGRAM),
    "begin": "a block begins with its own line, `if …`, `repeat …`, `task …`; leave `begin` out",
    "end": _CLOSER,
    "loop": _LOOP,
    "next": _NEXT,
    "foreach": "write `for each b in PATTERN`",
    "goto": f"there are no jumps: {_LOOP}",
    "switch": _CHOICE,
    "case": _CHOICE,
    "halt": _STOP,
    "exit": _STOP,
    "quit": _STOP,
    "speed": _MODAL,
    "vel": _MODAL,
    "acc": _MODAL,
    "accel": _MODAL,
    "blend": _MODAL,
    "zone": _MODAL,
    "int": _DECLARED,
    "real": _DECLARED,
    "float": _DECLARED,
    "num": _DECLARED,
    "bool": _DECLARED,
    "string": _DECLARED,
    "decl": _DECLARED,
    "let": _DECLARED,
    "dim": _DECLARED,
}
"""Hint by the first word of a line, in lower case (RAPID, KRL, URScript, VAL, and others)."""

WAIT_FOR = _WAIT_UNTIL
"""Hint for `WAIT FOR`."""
WAIT_WORDS = frozenset(("for", "sec", "secs", "second", "seconds", "time"))
"""Words of other languages between `wait` and a time."""
WAIT_LEVEL: Mapping[str, str] = {
    "on": _WAIT_UNTIL,
    "off": "inputs are read by name: write `wait until not NAME`",
}
"""Hint for a level behind the name of a signal."""

WAIT_CONDITION = "a wait for a condition is written `wait until CONDITION`"
"""Hint for a condition behind `wait`."""
ELSE_IF = "write it as one word: `elseif CONDITION`"
"""Hint for `else if`."""
COMPARISONS: Mapping[str, str] = {
    **dict.fromkeys(("eq", "equal", "equals"), "="),
    **dict.fromkeys(("ne", "neq"), "<>"),
    **dict.fromkeys(("gt", "greater"), ">"),
    **dict.fromkeys(("lt", "less"), "<"),
    **dict.fromkeys(("ge", "gte"), ">="),
    **dict.fromkeys(("le", "lte"), "<="),
}
"""Comparisons that are words, and their signs here."""
STEP = "write `{0} = {0} + 1`: an assignment names the variable on both sides"
"""Hint for `x++` and `x += 1`."""
FOR = "write `for i = FIRST to LAST`, or `for each b in PATTERN`"
"""Hint for other headers of `for`."""
COMMENT = "a comment begins with `#`"
"""Hints for signs of comments of other languages."""
COMMENT_OR_NOT = f"{COMMENT}; in a condition write `not`"
"""Hint for `!` with a blank behind it."""
COMMENT_SIGNS: Mapping[str, str] = {";": "", "%": "", "*": "", "-": "-", "/": "*"}
"""Signs with which a comment begins elsewhere, by the required next characters; empty for anything."""
ARGUMENTS = "a comma stands between arguments: `Name a, b`"
"""Hint for an argument right behind another one."""
MEMBERS = "a comma stands between values: `(a, b)`"
"""Hint for a value right behind another one in parentheses."""
SET = _SET
"""Hint for `set NAME to …`."""
LEVELS: Mapping[str, str] = {
    **dict.fromkeys(("high", "true"), "on"),
    **dict.fromkeys(("low", "false"), "off"),
}
"""Levels of digital outputs, and their equivalents here."""
LEFT_OVER: Mapping[str, str] = {
    ";": "each statement stands on a line of its own, without `;`",
    ":": "leave the `:` out",
    ",": "a location is written in parentheses, `(x, y, z)`; what follows it stands without a comma",
    "=": "what follows a word such as `speed` stands without `=`",
    "!": "write `not`",
}
"""Hint for a sign behind the end of a statement."""
NO_VALUE: Mapping[str, str] = {
    "=": "what follows a word such as `speed` stands without `=`",
    "*": "there is no power: write `x * x`",
}
"""Hint for a sign in place of a value."""
UNITS: Mapping[str, str] = {
    **dict.fromkeys(("sec", "secs", "second", "seconds"), "s"),
    **dict.fromkeys(("msec", "millisecond", "milliseconds"), "ms"),
    **dict.fromkeys(("minute", "minutes"), "min"),
    **dict.fromkeys(("millimeter", "millimeters", "millimetre", "millimetres"), "mm"),
    **dict.fromkeys(("meter", "meters", "metre", "metres"), "m"),
    **dict.fromkeys(("inches",), "inch"),
    **dict.fromkeys(("degree", "degrees"), "deg"),
    **dict.fromkeys(("radian", "radians"), "rad"),
    **dict.fromkeys(("percent", "pct"), "%"),
    **dict.fromkeys(("newton", "newtons"), "N"),
}
"""Units written out, and how they are written here."""

DECIMAL = "decimals are written with a point: `{0}.{1}`"
"""Hint for `0,5`."""

_TIGHT_COUNTS = re.compile(r"(?:x[0-9]+)+")


def grid_hint(first: str, rest: str) -> str:
    """Return the correct form for the counts of a grid that stand together; empty where they do not.

    Args:
        first: text before the first `x`, such as `2`.
        rest: the word behind it, such as `x4x3`.
    """
    return f"write blanks: `{first}{rest.replace('x', ' x ')}`" if _TIGHT_COUNTS.fullmatch(rest) else ""
