"""Diagnostics of the part library (X924 and X925)."""

from collections.abc import Iterable

from ropsim.core import Category, RopsimError, Severity, define, did_you_mean, there_are

CONFLICTING_MEASURES = define(
    "X924",
    "conflicting-measures-of-a-part",
    Severity.ERROR,
    "the parameters of a part do not fit together, or one is outside its range",
    """
Each parameter of a library part has a range, and some have another parameter as their upper bound: the
suction cups of a gripper would overlap if their diameter exceeded their distance.

```toml
part = { kind = "vacuum_gripper", cup_diameter = 60, cups_x = 2, pitch = 50 }     # wrong
part = { kind = "vacuum_gripper", cup_diameter = 40, cups_x = 2, pitch = 50 }     # right
```

`ropsim part show KIND` prints the parameters with their ranges.
""",
)

UNKNOWN_PART = define(
    "X925",
    "unknown-part",
    Severity.ERROR,
    "the part library has no kind, model or parameter of this name",
    """
A script or a command names a kind of part, a model of it or a parameter that the library does not have.
`ropsim part list` prints the kinds, `ropsim part show KIND` the models and parameters of one.

```python
part = ropsim.parts.library_part("two_finger_gripper", "franka_hand", stroke=0.06)
```
""",
    Category.USAGE,
)


class UnknownPartError(RopsimError):
    """The part library has no kind, model or parameter of the requested name."""

    def __init__(self, sort: str, name: str, known: Iterable[str]) -> None:
        names = tuple(known)
        super().__init__(
            UNKNOWN_PART.at(
                None,
                f"no {sort} is called `{name[:64]}`, {there_are(names)}",
                hint=did_you_mean(name, names) or "choose one of these names",
                data={"found": name, "allowed": names},
            )
        )


class PartValueError(RopsimError):
    """A parameter of a part is outside its range, or exceeds another one."""
