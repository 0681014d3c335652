"""A worker that computes nothing: what the name of a program says, it does."""

import os
import time
from multiprocessing.connection import Connection

from ropsim.studio.testing import jobs, orders, replies

GIVEN_UP: list[orders.Request] = []
"""What ended the first estimate that takes long; the second one does not."""
LONG_WAYS: set[int] = set()
"""Jobs whose runs have ways that are looked at without end."""
UNIT = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)


def main(connection: Connection) -> None:
    """Answer until the pipe is closed."""
    while True:
        try:
            request = connection.recv()
        except EOFError:
            return
        match request.content:
            case orders.Stop():
                return
            case (
                jobs.OpenScene()
                | jobs.Simulate()
                | jobs.LiveStart()
                | jobs.SaveRun()
                | jobs.LookAtWays()
                | jobs.JogJoints()
                | jobs.JogTcp()
                | jobs.ListTasks()
                | jobs.CheckTasks()
                | jobs.EstimateTasks()
                | jobs.Tell()
                | jobs.OfferWords()
            ):
                connection.send(replies.Answer(request.number, _reply(connection, request)))


def _reply(connection: Connection, request: orders.Request) -> replies.Reply:
    match request.content:
        case jobs.OpenScene(_, texts):
            return replies.SceneReply({"unsaved": sorted(texts)}, (), {"abc": b"glTF"})
        case jobs.Simulate() | jobs.LiveStart() | jobs.SaveRun() | jobs.LookAtWays() as job:
            return _run(connection, request.number, job)
        case jobs.JogJoints(_, q, _):
            return replies.JogReply(q, UNIT, ((1, UNIT),), reached=True, words=(("info", "all is well"),))
        case jobs.ListTasks(_, texts):
            return replies.TasksReply({"type": "task_list", "unsaved": sorted(texts)})
        case jobs.CheckTasks(_, _, number, steps):
            return _check(number, steps)
        case jobs.EstimateTasks(_, _, _, "slow") if not GIVEN_UP:
            GIVEN_UP.append(connection.recv())
            return replies.Failed("given up")
        case jobs.EstimateTasks(_, _, number, program):
            return replies.TasksReply({"type": "tasks_estimated", "id": number, "program": program})
        case job:
            return _tell(connection, job)


def _run(connection: Connection, number: int, job: jobs.RunJob) -> replies.Reply:
    match job:
        case jobs.Simulate() as job:
            return _simulate(connection, number, job)
        case jobs.LiveStart() as job:
            return _live(connection, number, job)
        case jobs.SaveRun(kept, form):
            return replies.SavedRun(f"{form} {kept}".encode())
        case jobs.LookAtWays(kept) if kept in LONG_WAYS:
            while not isinstance(connection.recv().content, orders.Cancel):
                pass
            return replies.Failed("given up")
        case jobs.LookAtWays(kept):
            return replies.WaysReply(({"code": "S751"},), {"warnings": kept})


def _tell(connection: Connection, job: object) -> replies.Reply:
    if isinstance(job, jobs.OfferWords):
        return replies.OfferedReply(job.line, (*job.commands, *sorted(job.texts)))
    if not isinstance(job, jobs.Tell):
        return replies.Failed("this toy cannot do that")
    match job.line.split():
        case []:
            return replies.ToldReply(job.commands, "answered", ("it stands",))
        case ["crash"]:
            os._exit(3)
        case ["endless"]:
            while not isinstance(connection.recv().content, orders.Cancel):
                pass
            return replies.Failed("given up")
        case ["repeat", *_]:
            return replies.ToldReply(job.commands, "open")
        case ["save", name]:
            return replies.ToldReply(job.commands, "answered", program=(name, "\n".join(job.commands)))
        case _:
            commands = (*job.commands, job.line)
            return replies.ToldReply(commands, "moved", pack=" ".join(commands).encode(), since=1.0)


def _check(number: int, steps: jobs.TaskSteps) -> replies.Reply:
    if steps and steps[0].name == "crash":
        os._exit(3)
    text = " ".join(one.name for one in steps)
    return replies.TasksReply({"type": "tasks_checked", "id": number, "text": text})


def _simulate(connection: Connection, number: int, job: jobs.Simulate) -> replies.Reply:
    text = job.texts.get("programs/main.task", "")
    connection.send(replies.Answer(number, replies.Progress("half way")))
    match job.program:
        case "crash":
            os._exit(3)
        case "deaf":
            time.sleep(3600)
        case "endless":
            while not isinstance(connection.recv().content, orders.Cancel | orders.Renew):
                pass
            return replies.RunReply("cancelled", job.program)
    if job.cause == "text_beside_live":
        return replies.RunReply("done", job.program, made="nothing")
    if "wrong" in text:
        return replies.RunReply("refused", job.program, findings=({"code": "N201"},))
    if "far" in text:
        LONG_WAYS.add(number)
    pack = f"{text}|{len(job.inputs)}".encode()
    return replies.RunReply("done", job.program or "main", pack=pack, ways="seen" in text)


def _live(connection: Connection, number: int, job: jobs.LiveStart) -> replies.Reply:
    for payload in ({"type": "live", "state": job.begin, "speed": job.speed}, {"type": "layout"}):
        connection.send(replies.Answer(number, replies.LiveMessage(payload)))
    connection.send(replies.Answer(number, replies.LiveFrame(b"RS frame")))
    inputs: list[jobs.InputChange] = []
    while True:
        match connection.recv().content:
            case orders.SetSignal(name, value):
                inputs.append(jobs.InputChange(name, 1.0, value))
            case orders.LiveControl("stop") | orders.Cancel():
                return replies.RunReply("done", job.program, pack=b"live", inputs=tuple(inputs))
