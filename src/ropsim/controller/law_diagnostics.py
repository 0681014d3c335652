"""What can be wrong with the data of a joint controller."""

from ropsim.core import RopsimError, Severity, define

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


class GainError(RopsimError):
    """The gains do not fit the arm."""
