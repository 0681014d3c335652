"""The worker's loop: jobs in, replies out; nothing that a user wrote ends it."""

import contextlib
from multiprocessing.connection import Connection

from ropsim.core import RopsimError, collect_seldom, keep_from_collection, shortage
from ropsim.studio.desk.desk import Desk
from ropsim.studio.desk.line import Cancelled, Line
from ropsim.studio.desk.mailbox import Mailbox, StopAsked, given_up
from ropsim.studio.wire.jobs import Job, LiveStart, Simulate
from ropsim.studio.wire.replies import Failed, Reply, RunReply
from ropsim.userfiles import KEPT_ANSWERS
from ropsim.workbench import Workspace


def main(connection: Connection) -> None:
    """Answer requests until the other end requests a stop or is closed.

    Args:
        connection: this process's end of the pipe; it carries `Request` and `Answer`.
    """
    collect_seldom()
    desk = Desk(workspace=Workspace(KEPT_ANSWERS))
    mailbox = Mailbox(connection)
    with contextlib.suppress(StopAsked):
        while True:
            number, job = mailbox.next_job()
            mailbox.answer(number, answered(desk, job, mailbox.line(number)))
            desk.warm()
            desk.workspace.keep()
            keep_from_collection()


def answered(desk: Desk, job: Job, line: Line) -> Reply:
    """Return the reply to a job, also if it fails."""
    try:
        return desk.do(job, line)
    except Cancelled:
        return given_up(job)
    except MemoryError:
        return failure(job, "there is not enough memory for this run: simulate fewer passes of its loops")
    except RopsimError as error:
        return failure(job, error.diagnostic.message)
    except StopAsked:
        raise
    except Exception as error:  # the worker must outlive its own faults
        lacking = shortage(error)
        fault = f"a fault of ropsim: {type(error).__name__}: {error}"[:500]
        return failure(job, lacking.message if lacking else fault)


def failure(job: Job, words: str) -> Reply:
    """Return the reply that a job has failed."""
    return RunReply("failed", job.program, words) if isinstance(job, Simulate | LiveStart) else Failed(words)
