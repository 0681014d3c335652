"""What can be wrong with the signals of devices in a cell file (X820, X821)."""

from ropsim.core import Severity, define

INPUT_SET_TWICE = define(
    "X820",
    "input-set-twice",
    Severity.ERROR,
    "two things set the same input",
    """
A device tells by an input where it is: `is_on`, `is_off`, `in_place`, or the `signal` of a `stop`. What such
an input says must come from one place only; another device or `changes` of the signal would contradict it.
Give each of them an input of its own.

```toml
[devices.door]
is_on = "door_open"
is_off = "door_closed"         # not "door_open" again

[signals.door_open]
input = 1                      # without `changes`
```
""",
)

DEVICES_IN_A_CIRCLE = define(
    "X821",
    "devices-in-a-circle",
    Severity.ERROR,
    "devices follow each other in a circle",
    """
A device follows an input that it sets itself, or that a device sets which in the end follows it. It would
start and stop itself without end, in no time. Let a device follow an output, and a program set that when the
input says so.

```toml
[devices.door]
signal = "door_closed"         # wrong: it leaves `off` as soon as it is there, and comes back at once
is_off = "door_closed"
```
""",
)
