"""Orders of the web process to a worker: each carries the number of its job and has no answer of its own."""

from typing import Literal, TypeAlias

from msgspec import Struct

from ropsim.core import frozen_dataclass
from ropsim.studio.wire.jobs import Job, Name, Share, Simulate


@frozen_dataclass
class Cancel:
    """Cancel the job of this number; its reply says `cancelled`."""


@frozen_dataclass
class Renew:
    """The texts have changed: continue if their content is the same (`Renewed`), else cancel the job.

    `run` is the number under which the run goes on.
    """

    run: int
    job: Simulate


class LiveControl(Struct, frozen=True, tag_field="type", tag="live_control"):
    """Hold a live run on its path, let it go on or make one step, or end it; the recording is kept."""

    action: Literal["hold", "continue", "step", "stop"]


class LiveOverride(Struct, frozen=True, tag_field="type", tag="live_override"):
    """Share of their planned speed at which the motions of the live run are followed, 0 to 1."""

    value: Share


class LiveSpeed(Struct, frozen=True, tag_field="type", tag="live_speed"):
    """Simulated seconds per second of the live run."""

    speed: float


class SetSignal(Struct, frozen=True, tag_field="type", tag="signal"):
    """Set an input of the cell in a live run; the simulator stamps it with simulated time."""

    name: Name
    value: float


@frozen_dataclass
class Stop:
    """End the worker process (number 0); a running job is given up."""


LiveOrder: TypeAlias = LiveControl | LiveOverride | LiveSpeed | SetSignal
Order: TypeAlias = Cancel | Renew | LiveOrder | Stop


@frozen_dataclass
class Request:
    """To the worker: a job with its number, or an order for the job of that number."""

    number: int
    content: Job | Order
