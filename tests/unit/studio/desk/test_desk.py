"""The worker: scenes, runs and jogs through its real pipe."""

import gzip
import json
import struct
import threading
from collections.abc import Iterator
from dataclasses import dataclass, field
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import pytest

from ropsim.icr import read_text
from ropsim.records import read_inputs
from ropsim.studio.testing import (
    Answer,
    Cancel,
    Cause,
    Failed,
    Job,
    JogJoints,
    JogReply,
    JogTcp,
    LiveControl,
    LiveFrame,
    LiveMessage,
    LiveStart,
    OpenScene,
    Order,
    Planned,
    Progress,
    Renew,
    Renewed,
    Reply,
    Report,
    Request,
    RunForm,
    RunReply,
    SavedRun,
    SaveRun,
    SceneReply,
    SetSignal,
    Simulate,
    Stop,
    main,
)
from support.live import CELL, KEYS, project
from support.patience import PATIENCE

BAD = "program p\nmoov home\n"
ENDLESS = "program p\nunits mm, deg, s\nrepeat 100000\n  wait 3600 s\nendr\n"
ASKING = "program p\nunits mm, deg, s\nmov joints (0, 60, -150, 0, -60, 0)\nwait until start\n"


@dataclass
class Worker:
    """The other end of the pipe."""

    connection: Connection
    number: int = 0
    replies: dict[int, Reply] = field(default_factory=dict)
    reports: list[Report] = field(default_factory=list)

    def send(self, job: Job) -> int:
        self.number += 1
        self.connection.send(Request(self.number, job))
        return self.number

    def order(self, number: int, order: Order) -> None:
        self.connection.send(Request(number, order))

    def hear(self) -> Answer:
        assert self.connection.poll(PATIENCE)
        answer: Answer = self.connection.recv()
        if isinstance(answer.content, Progress | Planned | Renewed | LiveMessage | LiveFrame):
            self.reports.append(answer.content)
        else:
            self.replies[answer.number] = answer.content
        return answer

    def reply(self, number: int) -> Reply:
        while number not in self.replies:
            self.hear()
        return self.replies[number]

    def ask(self, job: Job) -> Reply:
        return self.reply(self.send(job))

    def run(self, job: Simulate | LiveStart) -> RunReply:
        reply = self.ask(job)
        assert isinstance(reply, RunReply)
        return reply


@pytest.fixture
def worker() -> Iterator[Worker]:
    near, far = Pipe()
    thread = threading.Thread(target=main, args=(far,), daemon=True)
    thread.start()
    yield Worker(near)
    near.send(Request(0, Stop()))
    thread.join(PATIENCE)
    assert not thread.is_alive()
    near.close()
    far.close()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return project(tmp_path, KEYS)


def simulate(folder: Path, program: str = KEYS) -> Simulate:
    return Simulate(str(folder), {"programs/main.task": program}, "", "kinematic")


def test_a_scene_has_the_arm_and_the_parts(worker: Worker, folder: Path) -> None:
    reply = worker.ask(OpenScene(str(folder), {}))
    assert isinstance(reply, SceneReply)
    assert reply.scene is not None
    bodies = reply.scene["bodies"]
    assert isinstance(bodies, list)
    assert {"base", "link6", "tool:jaws", "box_1"} <= {body["name"] for body in bodies}
    assert reply.findings == ()


def test_a_broken_cell_file_has_findings_and_no_arm_to_jog(worker: Worker, folder: Path) -> None:
    reply = worker.ask(OpenScene(str(folder), {"cell.toml": "[robot]\nmodel = 3\n"}))
    assert isinstance(reply, SceneReply)
    assert reply.scene is None
    (finding, *_) = reply.findings
    assert finding["span"] == {"source": "cell.toml", "line": 2, "column": 9, "end_line": 2, "end_column": 10}
    jogged = worker.ask(JogJoints("robot", (0.0,) * 6, ""))
    assert isinstance(jogged, Failed)
    assert "no cell is open" in jogged.message


@pytest.mark.parametrize(
    "text", ["", "\0", "[", "[robot]\n", "a = 1e400", "[robot]\nmodel = 'puma560'\nx = 1"]
)
def test_no_cell_file_ends_the_worker(worker: Worker, folder: Path, text: str) -> None:
    assert isinstance(worker.ask(OpenScene(str(folder), {"cell.toml": text})), SceneReply)
    refused = worker.run(Simulate(str(folder), {"cell.toml": text}, "", "dynamic"))
    assert refused.state == "refused"
    assert refused.findings


def test_a_program_with_errors_is_refused_with_its_line(worker: Worker, folder: Path) -> None:
    reply = worker.run(simulate(folder, BAD))
    assert (reply.state, reply.pack) == ("refused", None)
    span = reply.findings[0]["span"]
    assert isinstance(span, dict)
    assert (span["source"], span["line"]) == ("programs/main.task", 2)


def test_what_cannot_be_found_is_refused_in_words(worker: Worker, folder: Path) -> None:
    for job in (
        Simulate(str(folder), {}, "mian", "dynamic"),
        Simulate(str(folder / "no"), {}, "", "dynamic"),
    ):
        reply = worker.run(job)
        assert reply.state == "refused"
        assert reply.findings[0]["message"]


def test_a_run_ends_with_a_pack(worker: Worker, folder: Path) -> None:
    reply = worker.run(simulate(folder, "program p\nunits mm, deg\nmov joints (0, 60, -150, 0, -60, 0)\n"))
    assert (reply.state, reply.program) == ("done", "main")
    assert reply.pack is not None
    assert reply.pack[:2] == b"\x1f\x8b"


OUT_OF_REACH = (
    "program p\nunits mm, deg\nmov joints (0, 60, -150, 0, -60, 0)\n"
    "mov (5000, 0, 0; down)\nprint 1\nmov home\n"
)


def test_planning_findings_come_before_the_drives_are_simulated(worker: Worker, folder: Path) -> None:
    texts = {"programs/main.task": OUT_OF_REACH}
    reply = worker.run(Simulate(str(folder), texts, "", "dynamic"))
    assert reply.state == "done"
    (planned,) = (one for one in worker.reports if isinstance(one, Planned))
    (finding,) = (one for one in planned.findings if one["severity"] == "error")
    span = finding["span"]
    assert isinstance(span, dict)
    assert (span["source"], span["line"]) == ("programs/main.task", 4)


def test_a_comment_or_a_blank_line_simulates_nothing(worker: Worker, folder: Path) -> None:
    first = worker.run(simulate(folder, OUT_OF_REACH))
    said = len(worker.reports)
    moved = worker.run(simulate(folder, "# new\n" + OUT_OF_REACH.replace("print", "\n# here\nprint")))
    assert (first.made, moved.made) == ("simulated", "kept")
    assert worker.reports[said:] == []
    assert moved.pack is not None
    assert first.pack is not None
    before, after = header_of(first.pack), header_of(moved.pack)
    assert [one["span"]["line"] for one in before["findings"]] == [4]
    assert [one["span"]["line"] for one in after["findings"]] == [5]
    lines = {one["text"]: one["span"]["line"] for one in after["events"] if one["kind"] == "message"}
    assert lines == {"1": 8}
    there = {3: 4, 4: 5, 5: 8, 6: 9}
    assert {3, 6} <= set(values_of(before, "line"))
    assert values_of(after, "line") == [there[line] for line in values_of(before, "line")]


def test_the_text_of_before_comes_back_to_its_lines(worker: Worker, folder: Path) -> None:
    first = worker.run(simulate(folder, OUT_OF_REACH))
    worker.run(simulate(folder, "\n\n" + OUT_OF_REACH))
    assert worker.run(simulate(folder, OUT_OF_REACH)).pack == first.pack


@pytest.mark.parametrize(
    "texts",
    [
        {"programs/main.task": OUT_OF_REACH.replace("print 1", "print 2")},
        {"programs/main.task": OUT_OF_REACH, "cell.toml": CELL.replace("mass = 0.5", "mass = 0.6")},
    ],
    ids=["program", "cell"],
)
def test_another_content_is_simulated(worker: Worker, folder: Path, texts: dict[str, str]) -> None:
    worker.run(simulate(folder, OUT_OF_REACH))
    assert worker.run(Simulate(str(folder), texts, "", "kinematic")).made == "simulated"


def test_a_comment_in_the_cell_file_simulates_nothing(worker: Worker, folder: Path) -> None:
    worker.run(simulate(folder, OUT_OF_REACH))
    texts = {"programs/main.task": OUT_OF_REACH, "cell.toml": "# a cell\n\n" + CELL}
    assert worker.run(Simulate(str(folder), texts, "", "kinematic")).made == "kept"


def test_a_live_run_stays_for_comments_and_beside_what_was_typed_meanwhile(
    worker: Worker, folder: Path
) -> None:
    short = "program p\nunits mm, deg, s\nprint 1\n"

    def made(program: str, cause: Cause) -> str:
        texts = {"programs/main.task": program}
        return worker.run(Simulate(str(folder), texts, "", "dynamic", cause=cause)).made

    worker.run(LiveStart(str(folder), {"programs/main.task": short}, "", 8.0))
    assert made("# two\n" + short, "text_beside_live") == "kept"
    other = short.replace("1", "2")
    assert made(other, "text_beside_live") == "nothing"
    assert made(other + "# two\n", "text") == "nothing"
    assert made(short, "text") == "kept"
    assert made(other, "text") == "simulated"
    worker.run(LiveStart(str(folder), {"programs/main.task": short}, "", 8.0))
    assert made(short, "asked") == "simulated"


LONG = "program p\nunits mm, deg, s\nrepeat 3000\n  mov joints (0, 60, -150, 0, -60, 0)\n  mov home\nendr\n"


def test_a_run_goes_on_for_newer_texts_of_the_same_content(worker: Worker, folder: Path) -> None:
    number = worker.send(simulate(folder, LONG))
    while not worker.reports:
        worker.hear()
    worker.order(number, Renew(7, simulate(folder, "# long\n" + LONG)))
    while Renewed(7) not in worker.reports:
        worker.hear()
    worker.order(number, Renew(8, simulate(folder, LONG.replace("3000", "1"))))
    reply = worker.reply(number)
    assert isinstance(reply, RunReply)
    assert reply.state == "cancelled"
    assert Renewed(8) not in worker.reports


def test_the_newest_run_can_be_kept_as_files(worker: Worker, folder: Path, tmp_path: Path) -> None:
    texts = {"programs/main.task": ASKING}
    number = worker.send(LiveStart(str(folder), texts, "", 8.0))
    while not any(isinstance(one, LiveFrame) for one in worker.reports):
        worker.hear()
    worker.order(number, SetSignal("start", 1.0))
    live = worker.reply(number)
    assert isinstance(live, RunReply)
    forms: tuple[tuple[str, RunForm], ...] = (("run.npz", "recording"), ("run.json", "inputs"))
    for name, form in forms:
        saved = worker.ask(SaveRun(number, form))
        assert isinstance(saved, SavedRun)
        place = tmp_path / name
        place.write_bytes(saved.content)
        assert [(one.signal, one.time, one.value) for one in read_inputs(place).inputs] == [
            (one.signal, one.time, one.value) for one in live.inputs
        ]
    report, code = (worker.ask(SaveRun(number, form)) for form in ("report", "code"))
    assert isinstance(report, SavedRun)
    assert report.content[:15].lower() == b"<!doctype html>"
    assert isinstance(code, SavedRun)
    assert read_text(code.content.decode())[0] is not None
    assert isinstance(worker.ask(SaveRun(number + 5, "recording")), Failed)


def test_a_report_that_is_kept_has_the_verdict_of_the_page(worker: Worker, folder: Path) -> None:
    warned = f"{KEYS}mov joints (0, 60, -150, 0, -60, 0) speed 100 mm/s\n"
    number = worker.send(simulate(folder, warned))
    run = worker.reply(number)
    assert isinstance(run, RunReply)
    assert run.pack is not None
    result = header_of(run.pack)["result"]
    assert result["warnings"] == 1
    report = worker.ask(SaveRun(number, "report"))
    assert isinstance(report, SavedRun)
    page = report.content.decode()
    assert result["verdict"]["text"] in page[: page.index("</header>")]


def header_of(pack: bytes) -> dict[str, Any]:
    content = gzip.decompress(pack)
    (length,) = struct.unpack_from("<I", content, 4)
    header: dict[str, Any] = json.loads(content[8 : 8 + length])
    return header


def values_of(header: dict[str, Any], channel: str) -> list[int]:
    (found,) = (one for one in header["channels"] if one["name"] == channel)
    code = found["columns"][0]["code"]
    return [round(value) for value in code["values"] if value]


def test_a_long_wait_can_be_given_up_and_the_worker_goes_on(worker: Worker, folder: Path) -> None:
    number = worker.send(simulate(folder, ENDLESS))
    while not worker.reports:
        worker.hear()
    worker.order(number, Cancel())
    reply = worker.reply(number)
    assert isinstance(reply, RunReply)
    assert reply.state == "cancelled"
    assert worker.run(simulate(folder, "program p\nmov home\n")).state == "done"


def test_a_job_that_waits_can_be_given_up(worker: Worker, folder: Path) -> None:
    first, second = worker.send(simulate(folder, ENDLESS)), worker.send(simulate(folder))
    worker.order(second, Cancel())
    assert worker.reply(second) == RunReply("cancelled", "")
    assert first not in worker.replies
    worker.order(first, Cancel())
    worker.reply(first)


def test_a_live_run_takes_keys_and_runs_again_from_its_inputs(worker: Worker, folder: Path) -> None:
    texts = {"programs/main.task": ASKING}
    number = worker.send(LiveStart(str(folder), texts, "", 8.0))
    while not any(isinstance(one, LiveFrame) for one in worker.reports):
        worker.hear()
    worker.order(number, SetSignal("start", 1.0))
    live = worker.reply(number)
    assert isinstance(live, RunReply)
    assert (live.state, [one.signal for one in live.inputs]) == ("done", ["start"])
    again = worker.run(Simulate(str(folder), texts, "", "dynamic", live.inputs))
    assert again.pack == live.pack


def test_a_live_run_that_is_stopped_keeps_what_it_has(worker: Worker, folder: Path) -> None:
    number = worker.send(LiveStart(str(folder), {"programs/main.task": ENDLESS}, "", 1.0))
    while not any(isinstance(one, LiveFrame) for one in worker.reports):
        worker.hear()
    worker.order(number, LiveControl("stop"))
    reply = worker.reply(number)
    assert isinstance(reply, RunReply)
    assert reply.state == "done"
    assert reply.pack is not None


def test_orders_for_a_run_that_is_over_are_dropped(worker: Worker, folder: Path) -> None:
    worker.run(simulate(folder, "program p\nmov home\n"))
    worker.order(1, LiveControl("stop"))
    assert isinstance(worker.ask(OpenScene(str(folder), {})), SceneReply)


def test_the_arm_is_jogged_where_the_scene_has_it(worker: Worker, folder: Path) -> None:
    worker.ask(OpenScene(str(folder), {}))
    q = (0.1, 1.2, -2.8, 0.2, 0.5, 0.3)
    there = worker.ask(JogJoints("robot", q, "jaws"))
    assert isinstance(there, JogReply)
    assert (there.q, there.reached, there.words) == (q, True, ())
    back = worker.ask(JogTcp("robot", (0.0, 1.1, -2.7, 0.1, 0.4, 0.1), "jaws", there.tcp))
    assert isinstance(back, JogReply)
    assert back.q == pytest.approx(q, abs=1e-9)
    assert isinstance(worker.ask(JogJoints("robot", q[:3], "jaws")), Failed)
    assert isinstance(worker.ask(JogJoints("robot", q, "jows")), Failed)
    assert isinstance(worker.ask(JogJoints("robot", (float("nan"),) * 6, "jaws")), Failed)
    assert isinstance(worker.ask(JogTcp("robot", q, "jaws", (0.0,) * 7)), Failed)


def test_the_worker_ends_when_the_other_end_is_gone(folder: Path) -> None:
    near, far = Pipe()
    thread = threading.Thread(target=main, args=(far,), daemon=True)
    thread.start()
    near.send(Request(1, LiveStart(str(folder), {"programs/main.task": ENDLESS}, "", 1.0)))
    assert near.poll(PATIENCE)
    near.close()
    thread.join(PATIENCE)
    assert not thread.is_alive()
    far.close()
