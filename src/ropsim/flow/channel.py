"""One recorded quantity: rows, or the times at which it changed."""

from enum import Enum

import numpy as np

from ropsim.spatial import Array, record


class ChannelGroup(Enum):
    """Heading of a channel in lists."""

    JOINTS = "joints"
    TCP = "tcp"
    PROGRAM = "program"
    SIGNALS = "signals"
    DEVICES = "devices"


@record
class Channel:
    """One recorded quantity, sampled in rows or held between changes.

    Attributes:
        values: of a sampled channel shape (n,) or (n, k), one row per recorded tick; of a held one shape
            (m,), the value from each change on.
        unit: SI unit as text, empty for counts and codes.
        columns: names of the k columns; empty for a single column.
        description: meaning and frame.
        group: heading in lists.
        subject: name of the station or device that it is of; empty for a channel of the cell.
        times: when a held channel changed [s], shape (m,), ascending; None for a sampled one.
    """

    values: Array
    unit: str
    columns: tuple[str, ...] = ()
    description: str = ""
    group: ChannelGroup = ChannelGroup.PROGRAM
    subject: str = ""
    times: Array | None = None

    def __repr__(self) -> str:
        """Return one line: name, shape and unit; no arrays."""
        shape = " × ".join(str(one) for one in np.shape(self.values))
        held = " changes" if self.held else ""
        unit = f" [{self.unit}]" if self.unit else ""
        return f"<Channel {self.description or 'without description'}{unit}: {shape}{held}>"

    @property
    def held(self) -> bool:
        """Return whether the value holds from each change until the next one."""
        return self.times is not None

    def rows(self, time: Array) -> Array:
        """Return the channel at the rows of its recording: its samples, or the values in force.

        The row at time t belongs to the control period that ends at t, so a change at t is in force in the
        next row only.

        Args:
            time: of the rows [s], shape (n,).

        Returns:
            Values, shape (n,) or (n, k).
        """
        if self.times is None:
            return self.values
        index = np.searchsorted(self.times, time, side="left") - 1
        return np.asarray(self.values[np.maximum(index, 0)])
