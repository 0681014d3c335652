"""What a job that is being done hears and says: orders in, reports out."""

from collections.abc import Sequence
from typing import Protocol

from ropsim.studio.wire.orders import Order
from ropsim.studio.wire.replies import Report


class Cancelled(Exception):  # noqa: N818 - it is no error
    """The job on hand has been given up by who asked for it."""


class Line(Protocol):
    """The way between a job and who asked for it."""

    @property
    def number(self) -> int:
        """Return the number of the job."""
        ...

    def report(self, content: Report) -> None:
        """Tell how the job goes."""
        ...

    def orders(self, seconds: float) -> Sequence[Order]:
        """Return what has been ordered since the last call, after waiting at most so long for the first.

        Raises:
            Cancelled: the job is to be given up.
        """
        ...
