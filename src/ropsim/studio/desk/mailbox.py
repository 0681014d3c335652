"""The worker's end of the pipe: jobs wait in order, orders reach the job that they are for."""

import contextlib
from collections import deque
from collections.abc import Iterator
from multiprocessing.connection import Connection

from ropsim.core import frozen_dataclass
from ropsim.studio.desk.line import Cancelled
from ropsim.studio.wire.jobs import (
    CheckTaskForm,
    CheckTasks,
    EstimateTasks,
    Job,
    JogJoints,
    JogTcp,
    ListTasks,
    LiveStart,
    LookAtWays,
    OfferWords,
    OpenScene,
    OpenTaskForm,
    SaveRun,
    Simulate,
    Tell,
)
from ropsim.studio.wire.orders import (
    Cancel,
    LiveControl,
    LiveOverride,
    LiveSpeed,
    Order,
    Renew,
    Request,
    SetSignal,
    Stop,
)
from ropsim.studio.wire.replies import Answer, Failed, Reply, Report, RunReply


class StopAsked(Exception):  # noqa: N818 - it is no error
    """The process is to end: on request, or because the other end is closed."""


@contextlib.contextmanager
def _until_gone() -> Iterator[None]:
    """Convert exceptions of a pipe to `StopAsked`, distinct from all others."""
    try:
        yield
    except (EOFError, OSError) as error:
        raise StopAsked from error


class Mailbox:
    """Requests that have come and not been done.

    Args:
        connection: this process's end of the pipe.
    """

    def __init__(self, connection: Connection) -> None:
        self._connection = connection
        self._jobs: deque[tuple[int, Job]] = deque()

    def next_job(self) -> tuple[int, Job]:
        """Return the next job and its number, waiting for it; orders for jobs that are done are dropped.

        Raises:
            StopAsked: the process is to end.
        """
        while not self._jobs:
            with _until_gone():
                request: Request = self._connection.recv()
            self._sort_in(request)
        return self._jobs.popleft()

    def orders(self, number: int, seconds: float) -> list[Order]:
        """Return the orders for a job that have come, waiting at most so long for the first message.

        Raises:
            Cancelled: the job is to be given up.
            StopAsked: the process is to end.
        """
        orders: list[Order] = []
        while (request := self._arrived(0.0 if orders else seconds)) is not None:
            seconds = 0.0
            match request.content:
                case Cancel() if request.number == number:
                    raise Cancelled
                case (LiveControl() | LiveOverride() | LiveSpeed() | SetSignal() | Renew()) as order if (
                    request.number == number
                ):
                    orders.append(order)
                case _:
                    self._sort_in(request)
        return orders

    def answer(self, number: int, content: Report | Reply) -> None:
        """Send a report or the reply of a job.

        Raises:
            StopAsked: the other end is closed.
        """
        with _until_gone():
            self._connection.send(Answer(number, content))

    def line(self, number: int) -> "JobLine":
        """Return the line of a job."""
        return JobLine(self, number)

    def _arrived(self, seconds: float) -> Request | None:
        with _until_gone():
            request: Request | None = self._connection.recv() if self._connection.poll(seconds) else None
        return request

    def _sort_in(self, request: Request) -> None:
        match request.content:
            case Stop():
                raise StopAsked
            case Cancel() | Renew():  # a job that has not begun is requested again
                self._drop(request.number)
            case (
                Simulate()
                | LiveStart()
                | SaveRun()
                | LookAtWays()
                | OpenScene()
                | JogJoints()
                | JogTcp()
                | ListTasks()
                | CheckTasks()
                | EstimateTasks()
                | OpenTaskForm()
                | CheckTaskForm()
                | Tell()
                | OfferWords()
            ) as job:
                self._jobs.append((request.number, job))
            case _:  # an order for a live run that has just ended
                pass

    def _drop(self, number: int) -> None:
        """Answer a job that has not begun and is cancelled."""
        for waiting in [one for one in self._jobs if one[0] == number]:
            self._jobs.remove(waiting)
            self.answer(number, given_up(waiting[1]))


def given_up(job: Job) -> Reply:
    """Return the reply to a job that is cancelled."""
    return RunReply("cancelled", job.program) if isinstance(job, Simulate | LiveStart) else Failed("given up")


@frozen_dataclass
class JobLine:
    """The line of the job on hand."""

    mailbox: Mailbox
    number: int

    def report(self, content: Report) -> None:
        """Send a report on the job."""
        self.mailbox.answer(self.number, content)

    def orders(self, seconds: float) -> list[Order]:
        """Return the orders for the job; see `Mailbox.orders`."""
        return self.mailbox.orders(self.number, seconds)
