"""How the studio ends, in every phase, and how it goes on when one of its processes is killed."""

import contextlib
import json
import os
import signal
import subprocess
import time
from pathlib import Path

import pytest
from websockets.exceptions import ConnectionClosed

from support.patience import GLANCE, PATIENCE
from support.studio_client import Page, command, opened, page_of
from support.studio_family import ends, gone, language_servers, needs_proc, origins, workers
from support.studio_process import Studio
from support.usual_signals import usual_signals

pytestmark = pytest.mark.slow

MAIN = "programs/main.task"
ENDLESS = "program main\nrepeat\n  wait 1\nendr\n"
LONG = "program main\nwait 60\n"
"""Ten minutes and more where it is run live as slowly as can be."""
SHORT = "program main\nwait 1\n"
INITIALIZE = '{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}}'


def hear_newer(page: Page, run: int, state: str) -> None:
    """Wait until a run after the given one is in a state."""
    while page.hear("run", state=state)["id"] <= run:
        pass


def kill_workers(studio: Studio, page: Page) -> None:
    """Kill the workers and wait until the page has been told of each."""
    for pid in workers(studio.process.pid):
        os.kill(pid, signal.SIGKILL)
        assert page.hear("notice")["code"] == "U955"


def heard(page: Page) -> list[dict[str, object]]:
    """Return all that a page still hears until its socket is closed."""
    messages = []
    with contextlib.suppress(ConnectionClosed):
        while True:
            text = page.socket.recv(timeout=PATIENCE)
            messages += [json.loads(text)] if isinstance(text, str) else []
    return messages


@needs_proc
@pytest.mark.parametrize(
    ("phase", "number"),
    [
        ("resting", "SIGHUP"),
        ("simulating", "SIGTERM"),
        ("live", "SIGTERM"),
        ("live", "SIGINT"),
    ],
)
def test_an_end_of_the_whole_group_is_quiet_and_complete(studio: Studio, phase: str, number: str) -> None:
    with page_of(studio) as page, opened(studio, "/ws/lsp") as language:
        language.send(INITIALIZE)
        language.recv(timeout=PATIENCE)
        page.hear("scene")
        first = page.hear("run", state="done")["id"]
        if phase == "simulating":
            page.say(type="edit", document=MAIN, text=ENDLESS, version=1)
            hear_newer(page, first, "running")
        if phase == "live":
            page.start_live(0.1)
        servers = language_servers(studio.process.pid)
        assert (len(workers(studio.process.pid)), len(servers)) == (2, 1)
        os.killpg(studio.process.pid, signal.Signals[number])
        assert [one for one in heard(page) if one["type"] in {"notice", "scene"}] == []
        assert studio.process.wait(PATIENCE) == 0
    assert ends(studio.process.pid)
    assert gone(servers)
    assert studio.errors() == ""


@needs_proc
@pytest.mark.parametrize(("number", "count"), [("SIGINT", 1), ("SIGTERM", 1), ("SIGTERM", 2), ("SIGHUP", 2)])
def test_an_end_during_the_start_leaves_nothing(
    project: Path, tmp_path: Path, number: str, count: int
) -> None:
    home = tmp_path / "home"
    home.mkdir()
    with usual_signals():
        started = subprocess.Popen(
            [*command(tmp_path), "studio", str(project), "--no-browser"],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            start_new_session=True,
            env={**os.environ, "XDG_STATE_HOME": str(home), "XDG_CONFIG_HOME": str(home)},
        )
    end = time.monotonic() + PATIENCE
    while len(workers(started.pid)) < count and started.poll() is None and time.monotonic() < end:
        time.sleep(GLANCE)
    os.killpg(started.pid, signal.Signals[number])
    try:
        _, errors = started.communicate(timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        os.killpg(started.pid, signal.SIGKILL)
        raise
    assert (started.returncode, errors) == (0, b"")
    assert ends(started.pid)


@needs_proc
def test_asking_twice_ends_it_all_the_same_and_keeps_the_text(
    studio: Studio, project: Path, tmp_path: Path
) -> None:
    with page_of(studio) as page:
        page.hear("run", state="done")
        page.say(type="edit", document=MAIN, text="unsaved\n", version=1)
        page.hear("documents")
        studio.process.send_signal(signal.SIGINT)
        studio.process.send_signal(signal.SIGINT)
        assert studio.process.wait(PATIENCE) == 0
    assert ends(studio.process.pid)
    with Studio(project, tmp_path / "home", command=command(tmp_path)) as again, page_of(again) as page:
        assert page.hear("welcome")["documents"][1]["text"] == "unsaved\n"


@needs_proc
def test_every_process_may_be_killed_and_work_goes_on(studio: Studio) -> None:
    with page_of(studio) as page:
        page.hear("scene")
        first = page.hear("run", state="done")["id"]
        kill_workers(studio, page)
        assert page.hear("scene")["scene"] is not None
        page.say(type="edit", document=MAIN, text=ENDLESS, version=1)
        hear_newer(page, first, "running")
        page.start_live(1.0)
        kill_workers(studio, page)
        page.hear("live", state="over")
        assert "killed by the system" in page.hear("run", state="failed")["message"]
        page.say(type="edit", document=MAIN, text=SHORT, version=2)
        done = page.hear("run", state="done")["id"]
        for pid in origins(studio.process.pid):
            os.kill(pid, signal.SIGKILL)
        kill_workers(studio, page)
        page.say(type="edit", document=MAIN, text=SHORT + "wait 1\n", version=3)
        hear_newer(page, done, "done")
        with opened(studio, "/ws/lsp") as language:
            language.send(INITIALIZE)
            language.recv(timeout=PATIENCE)
            for pid in language_servers(studio.process.pid):
                os.kill(pid, signal.SIGKILL)
            with pytest.raises(ConnectionClosed):
                language.recv(timeout=PATIENCE)


def test_a_live_run_is_held_slowed_stopped_and_replaced_through_the_server(lent: Studio) -> None:
    with page_of(lent) as page:
        page.hear("run", state="done")
        page.say(type="edit", document=MAIN, text=LONG, version=1)
        page.hear("run", state="done")
        for _ in range(2):
            page.start_live(0.1)
            page.say(type="live_control", action="hold")
            page.hear("live", state="held")
            page.say(type="live_override", value=0.5)
            page.hear("live", state="held", override=0.5)
            page.say(type="edit", document=MAIN, text=LONG + "# more\n", version=2)  # it is not disturbed
            page.say(type="live_control", action="continue")
            page.hear("live", state="running")
            page.say(type="live_control", action="stop")
            page.hear("live", state="over")
            page.hear("run", state="done")
        page.start_live(0.1)
        page.say(type="run", program="", fidelity="kinematic")
        page.hear("live", state="over")
        page.hear("run", state="done")
