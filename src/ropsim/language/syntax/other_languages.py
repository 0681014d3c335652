"""Words of other robot languages, and what they are called here."""

from collections.abc import Mapping

_LIN = "did you mean `lin`?"
_MOV = "did you mean `mov`?"
_JOINTS = "joint coordinates are a target of `mov`: write `mov joints(…)`"
_CIRCLE = "a circular move names its point on the way first: write `circ via a to b`"
_TRIGGER = "outputs are set on the way of a motion: write `lin p at 3 mm after start do set NAME on`"
_SEARCH = "a motion ends by a condition: write `lin p until NAME store q`"
_SET = "outputs are set by name: write `set NAME on`, `set NAME off` or `set NAME = value`"
_RESET = "outputs are set by name: write `set NAME off`"
_WAIT_UNTIL = "inputs are read by name: write `wait until NAME`"
_WAIT_TIME = "a wait says its time with a unit: write `wait 0.5 s`"

HINTS: Mapping[str, str] = {
    "movel": _LIN,
    "moves": _LIN,
    "slin": _LIN,
    "movej": _MOV,
    "ptp": _MOV,
    "sptp": _MOV,
    "moveabsj": _JOINTS,
    "movec": _CIRCLE,
    "scirc": _CIRCLE,
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
}
"""What to write here, by the first word of a line, in lower case (RAPID, KRL, URScript, VAL)."""

WAIT_FOR = _WAIT_UNTIL
"""What to write for `WAIT FOR`."""
WAIT_LEVEL: Mapping[str, str] = {
    "on": _WAIT_UNTIL,
    "off": "inputs are read by name: write `wait until not NAME`",
}
"""What to write for a level behind the name of a signal."""
