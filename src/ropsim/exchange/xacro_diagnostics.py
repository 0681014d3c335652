"""What can be wrong with the macros of a robot file (code X992)."""

from ropsim.core import Severity, define

XACRO = define(
    "X992",
    "xacro-not-expanded",
    Severity.ERROR,
    "a macro, property, argument or expression of a xacro file cannot be expanded",
    """
Xacro files are expanded before they are read: arguments, properties, macros with parameters and blocks,
`if` and `unless`, included files, and expressions in `${...}` and `$(...)`. Expressions know numbers,
texts, lists and dictionaries, the operators of arithmetic and comparison, `and`, `or`, `not`, `x if c
else y`, indices, and the functions of mathematics; nothing else can be called, and no file is read but
those inside of the given folders. How deep macros call each other and how much they make is bounded
(X981).
""",
)
