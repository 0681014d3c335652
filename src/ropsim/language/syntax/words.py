"""The words of the language: statement heads, reserved words and words that this version excludes."""

HEADS = frozenset(
    [
        "program",
        "use",
        "import",
        "units",
        "classic",
        "strict",
        "robot",
        "frame",
        "loc",
        "tool",
        "signal",
        "const",
        "var",
        "pattern",
        "task",
        "needs",
        "assumes",
        "endp",
        "endtask",
        "endr",
        "endif",
        "endw",
        "endf",
        "endon",
        "endtry",
        "endwith",
        "endpar",
        "until",
        "else",
        "elseif",
        "mov",
        "movj",
        "lin",
        "movl",
        "circ",
        "movc",
        "spline",
        "open",
        "close",
        "load",
        "set",
        "pulse",
        "wait",
        "if",
        "while",
        "repeat",
        "for",
        "with",
        "break",
        "continue",
        "return",
        "stop",
        "parallel",
        "sync",
        "on",
        "resume",
        "restart",
        "skip",
        "try",
        "catch",
        "raise",
        "abort",
        "call",
        "print",
    ]
)
"""Words that start a statement; they cannot name anything else."""

VERBS = (
    "mov", "movj", "lin", "movl", "circ", "movc", "spline", "open", "close", "load", "set", "wait",
    "if", "while", "repeat", "for", "with", "break", "continue", "return", "stop", "call", "print", "endp",
    "endr", "endif", "endw", "endf", "endwith", "until", "else", "elseif", "task", "needs", "assumes",
    "frame", "loc", "tool", "signal", "const", "var", "pattern", "program", "units",
)  # fmt: skip
"""Statement words worth suggesting for a misspelt one."""

ACTIONS = frozenset(
    (
        "mov", "movj", "lin", "movl", "circ", "movc", "spline", "open", "close", "load", "set", "wait",
        "if", "while", "repeat", "for", "with", "break", "continue", "return", "stop", "call", "print",
    )
)  # fmt: skip
"""Statement words that stand in no other statement: one behind the end of a statement begins another one."""

MOTIONS = frozenset(("mov", "movj", "lin", "movl", "circ", "movc", "spline"))
"""Words that start a motion."""

RESERVED = HEADS | frozenset(
    [
        "and",
        "or",
        "not",
        "mod",
        "in",
        "above",
        "offset",
        "rel",
        "is",
        "to",
        "then",
        "do",
        "true",
        "false",
        "here",
        "home",
    ]
)
"""Words that cannot be names."""

END = "end"
"""Alone on a line it closes the innermost block; elsewhere it may be a name, but not that of a task."""

VIA = "via"
"""Stands before the points on the way of a motion; elsewhere it may be a name."""

ALONG, GAIN = "along", "gain"
"""Stand behind `track` and its value."""

MOTION_MODIFIERS = frozenset(["angle", "at", "store", "timeout", "track", ALONG, GAIN])
"""Words behind the target of a motion that hold for this motion only and for no other statement."""

SETTINGS = ("speed", "acc", "blend", "fine", "tool", "frame")
"""Settings of motions: behind `set`, behind a target and in `with`."""

INSIDE = (
    "speed", "acc", "blend", "fine", "tool", "frame", "angle", "at", "after", "before", "do", "until",
    "timeout", "store", "external", "free", "above", "offset", "rel", "then", "else", "step", "via", "config",
    "turns",
)  # fmt: skip
"""Words behind the beginning of a statement worth suggesting for a misspelt one."""

EXTERNAL = "external"
"""Stands behind a location, before the values of external axes; elsewhere it may be a name."""

FREE = "free"
"""Stands behind a location, or among its terms: its orientation is free; elsewhere it may be a name."""

NOT_YET = frozenset(
    [
        "on",
        "endon",
        "resume",
        "restart",
        "skip",
        "try",
        "catch",
        "endtry",
        "raise",
        "abort",
        "parallel",
        "endpar",
        "sync",
        "pulse",
        "use",
        "import",
        "robot",
    ]
)
"""Statements of the language that this version refuses by name."""

NOT_YET_MODIFIERS = frozenset(["time", "jtol", "force"])
"""Words after a motion target that this version refuses by name."""

OPENERS = {
    "task": ("endp", "endtask"),
    "repeat": ("endr", "until"),
    "if": ("endif",),
    "while": ("endw",),
    "for": ("endf",),
    "with": ("endwith",),
    "on": ("endon",),
    "try": ("endtry",),
    "parallel": ("endpar",),
}
"""Words that close a block, by the word that opens it."""
