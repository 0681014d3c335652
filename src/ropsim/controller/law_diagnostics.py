"""Errors in the data of a joint controller."""

from ropsim.core import Category, RopsimError, Severity, define

GAIN_COUNT = define(
    "C600",
    "gain-count-mismatch",
    Severity.ERROR,
    "a gain of the joint controller does not have one number per joint",
    """
The gains `kp`, `kv`, `ki`, `kf`, `ke` and `ka` of the cascaded P-PI controller are arrays with one number per
joint, in the order of the joints. One of them has more or fewer numbers than the arm has drives.

Give every joint its gain:

```toml
kp = [25.0, 25.0, 25.0, 30.0, 30.0, 30.0]
```
""",
)


GAINS_OF_ANOTHER_LAW = define(
    "C604",
    "gains-of-another-law",
    Severity.ERROR,
    "a controller has gains that its law does not take",
    """
The kind of a controller model says which law it is, and each law has gains of its own: `CascadedGains` for
`cascaded_p_pi`, `ComputedTorqueGains` for `computed_torque`, `FlowGains` for `flow_load_damping`, `PiGains`
for `parallel_pi`.
""",
)


class GainError(RopsimError):
    """The gains do not fit the arm."""


LAW_FAILS = define(
    "C601",
    "law-fails",
    Severity.ERROR,
    "a joint controller of your own does not do its work",
    """
A law of your own cannot be read as Python, raises an exception, cannot be compiled, reaches beyond its
arrays or puts out NaN. It is tried once in plain Python before a run, at rest and on its reference, with
every index checked; while it runs, indexes are checked too. The message says what it did, and at which line
of its source. An output that becomes infinite or NaN later ends the run with S701.

A compiled law is the source of `law`, whose arguments have names: `out`, and of `par`, `state`, `ref`,
`meas`, `sensed`, `drive`, `model`, `work`, `load`, `aux` those that it needs. It may use `math`, loops and
arithmetic on these arrays. `par` has the shape of the parameters, `state` one row for each name in
`traits.state_names`, `ref` and `meas` three rows, `out` one number per joint.

A law that is a Python object has `traits` and `step(now, state)`; the message says at what time it failed.
A law that fails while it runs ends the run there, so that the cycle time is not that of the program.
""",
    Category.UNFINISHED,
)

LAW_DOES_NOT_FIT = define(
    "C602",
    "law-does-not-fit",
    Severity.ERROR,
    "a joint controller does not fit the drives or the cell",
    """
What a law says about itself (`traits`) does not go together with the arm: it puts out voltages where a drive
takes torques, it has a negative delay, it names a row of its state that it does not have, it reads a
signal that the cell does not have, or a state of its drives, such as `pressure_a`, that one of them does not
have. The message says which states that drive has.
""",
)


class LawError(RopsimError):
    """A law does not work or does not fit."""
