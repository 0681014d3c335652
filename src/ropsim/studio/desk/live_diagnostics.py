"""Diagnostics of live runs (U980 to U989)."""

from ropsim.core import Severity, define

NO_INPUT = define(
    "U980",
    "no-such-input",
    Severity.WARNING,
    "a key is bound to something that is no input of the cell",
    """
In a live run keys set inputs of the cell, which stand under `[signals]` in `cell.toml` with a line
`input = NUMBER`. Outputs are set by the program alone. Bind the key to one of the inputs that are named.
""",
)
