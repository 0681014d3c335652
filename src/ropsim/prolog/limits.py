"""How much a goal or a text may take."""

from ropsim.core import frozen_dataclass


@frozen_dataclass
class Limits:
    """Limits of an engine and each of its goals.

    Attributes:
        seconds: time inside Prolog, of a goal with all its solutions, or of loading a text [s].
        inferences: steps of a goal up to its next solution, or None for no limit. The same goal takes the
            same number everywhere, so unlike time this limit has the same result on every machine; in the
            native Prolog calls of the host count some dozens.
        memory_bytes: memory of the whole engine, between 64 MiB and 2 GiB; of the native Prolog the memory of
            its stacks, and on Linux of all data except its code.
    """

    seconds: float = 10.0
    inferences: int | None = None
    memory_bytes: int = 256 << 20

    def __post_init__(self) -> None:
        if not 0.0 < self.seconds < 1e6:
            raise ValueError(f"seconds is {self.seconds}, allowed is a number above 0 and below 1000000")
        if self.inferences is not None and self.inferences < 1:
            raise ValueError(f"inferences is {self.inferences}, allowed is 1 and more")
        if not 64 << 20 <= self.memory_bytes <= 2 << 30:
            raise ValueError(f"memory_bytes is {self.memory_bytes}, allowed is {64 << 20} to {2 << 30}")
