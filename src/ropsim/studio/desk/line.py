"""Connection of a running job: orders in, reports out."""

from collections.abc import Sequence
from typing import Protocol

from ropsim.studio.wire.orders import Order
from ropsim.studio.wire.replies import Report


class Cancelled(Exception):  # noqa: N818 - it is no error
    """The job on hand has been given up by its sender."""


class Line(Protocol):
    """The connection between a job and its sender."""

    @property
    def number(self) -> int:
        """Return the number of the job."""
        ...

    def report(self, content: Report) -> None:
        """Report the progress of the job."""
        ...

    def orders(self, seconds: float) -> Sequence[Order]:
        """Return the orders since the last call, after waiting at most so long for the first.

        Raises:
            Cancelled: the job is to be given up.
        """
        ...
