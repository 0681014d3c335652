"""The studio under pages that misbehave, and with files that do."""

import contextlib
import http.client
import json
import socket
import sys
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest
from websockets.exceptions import InvalidStatus

from ropsim.flow import Interventions
from ropsim.records import read_recording
from ropsim.records.inputs import read_inputs
from ropsim.workbench import new_project
from support import studio_launcher
from support.patience import PATIENCE
from support.studio_client import (
    Page,
    command,
    get,
    opened,
    page_of,
    secret,
    wait_for_journal,
)
from support.studio_family import gone, language_servers, needs_proc, workers
from support.studio_process import Studio, own_port

MAIN = "programs/main.task"
CLOSED = b"\x88\x02" + (1013).to_bytes(2, "big")
"""The frame that closes a socket with the words: try again later."""


@pytest.fixture
def project(tmp_path: Path) -> Path:
    return new_project(tmp_path / "cell")


@pytest.fixture
def studio(project: Path, tmp_path: Path) -> Iterator[Studio]:
    with Studio(project, tmp_path / "home", own_port(), command=command(tmp_path)) as running:
        yield running


@pytest.fixture(scope="module")
def shared(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Studio]:
    """Return a studio for tests that leave it as it was."""
    place = tmp_path_factory.mktemp("shared")
    with Studio(new_project(place / "cell"), place / "home", command=command(place)) as running:
        yield running


def test_nonsense_of_every_kind_is_told_and_the_page_goes_on(shared: Studio) -> None:
    with page_of(shared) as page:
        page.hear("run", state="done")
        for nonsense in (
            "",
            "[" * 200_000,
            '{"type":' * 100_000,
            '{"type":"signal","name":"gate","value":NaN}',
            json.dumps({"type": "edit", "document": "x" * 10_000_000, "text": "", "version": 1}),
            json.dumps({"type": "edit", "document": MAIN, "text": 1, "version": 1}),
            '{"type":"edit","document":"cell.toml","text":"\\ud800","version":1}',
            b"\x00\xff" * 1000,
        ):
            page.socket.send(nonsense)
            assert page.hear("notice")["code"] == "U953"
        for path in ("../../x.task", "/etc/passwd", "programs/../cell.toml", "C:\\x.task"):
            page.say(type="save", document=path, overwrite=True)
            assert page.hear("notice")["code"] == "U958"
        page.say(type="jog_tcp", id=1, station="robot", q=[0.0] * 6, tool="", target=[0, 0, 0, 0, 0, 0, 0])
        assert page.hear("jogged", id=1)["reached"] is False
        page.say(type="jog_joints", id=2, station="robot", q=[1e308] * 6, tool="")
        assert page.hear("jogged", id=2)["reached"] is False
        page.say(type="run", program="", fidelity="kinematic")
        page.hear("run", state="done")
    assert shared.errors() == ""


def test_a_tab_that_never_reads_is_dropped_and_holds_nobody_up(studio: Studio) -> None:
    with page_of(studio) as page:
        page.hear("run", state="done")
        with closing(deaf_socket(studio)) as deaf:
            for version in range(1, 27):  # 104 MB: more than may wait for a tab and the system holds for it
                page.say(type="edit", document=MAIN, text=f"# {version}" + " " * 4_000_000, version=version)
            page.say(type="save", document="programs/none.task", overwrite=False)
            assert page.hear("notice")["code"] == "U958"
            assert resident(studio.process.pid) < 400
            deaf.settimeout(PATIENCE)
            held = b""  # what was in the buffers; the closing words are for those who still listen by then
            while not held.endswith(CLOSED) and (more := deaf.recv(1_000_000)):
                held = held[-4:] + more


def deaf_socket(studio: Studio) -> socket.socket:
    """Return a connected tab that reads nothing."""
    deaf = socket.create_connection(("127.0.0.1", studio.port))
    host = f"127.0.0.1:{studio.port}"
    lines = (
        "GET /ws/studio HTTP/1.1",
        f"Host: {host}",
        f"Origin: http://{host}",
        f"Cookie: {secret(studio)['Cookie']}",
        "Connection: Upgrade",
        "Upgrade: websocket",
        "Sec-WebSocket-Version: 13",
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==",
    )
    deaf.sendall("\r\n".join((*lines, "", "")).encode())
    assert deaf.recv(1000).startswith(b"HTTP/1.1 101")
    hello = b'{"type":"hello","tab":"deaf"}'
    deaf.sendall(bytes([0x81, 0x80 | len(hello)]) + bytes(4) + hello)  # masked with zeros
    return deaf


def resident(pid: int) -> float:
    """Return the memory of a process [MB]; 0 where it cannot be told."""
    place = Path(f"/proc/{pid}/status")
    if not place.exists():
        return 0.0
    line = next(one for one in place.read_text("utf-8").splitlines() if one.startswith("VmRSS"))
    return int(line.split()[1]) / 1e3


@needs_proc
def test_many_tabs_share_few_language_servers_and_a_storm_leaves_none(
    project: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    most = 3
    monkeypatch.setenv(studio_launcher.MOST_LANGUAGE_SERVERS, str(most))
    with Studio(project, tmp_path / "home", command=command(tmp_path)) as studio:
        storm(studio, most)


def storm(studio: Studio, most: int) -> None:
    with contextlib.ExitStack() as stack:
        pages = [Page(stack.enter_context(opened(studio)), str(number)) for number in range(20)]
        assert sum(page.hear("welcome")["editing"] for page in pages) == 1
        languages = [stack.enter_context(opened(studio, "/ws/lsp")) for _ in range(most)]
        for language in languages:
            language.send('{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}}')
            language.recv(timeout=PATIENCE)
        with pytest.raises(InvalidStatus), opened(studio, "/ws/lsp"):
            pass
        assert len(language_servers(studio.process.pid)) == most
        for page in pages:
            page.hear("run", state="done")
    for _ in range(30):
        with opened(studio):
            pass
    assert gone(language_servers(studio.process.pid))
    assert len(workers(studio.process.pid)) == 2
    with page_of(studio) as page:
        page.hear("welcome")


def test_odd_addresses_are_not_found(shared: Studio) -> None:
    ours = secret(shared)
    for path in (
        "/run/../../etc/passwd",
        "/run/..%2f..%2fetc%2fpasswd",
        "/run/-1.pack",
        "/run/1e9.pack",
        f"/run/{'9' * 6000}.pack",
        "/run/%00.pack",
        "/run/%D9%A1.pack",
        "/mesh/..%2f..%2fcell.toml.glb",
        "/mesh/.glb",
        "/assets/..%2f..%2findex.html",
        "/assets/%2e%2e/index.html",
        "/assets//etc/passwd",
        "/assets/%00",
    ):
        assert get(shared, path, ours)[0] == 404, path


def test_the_next_studio_of_a_project_takes_the_open_page_back(
    studio: Studio, project: Path, tmp_path: Path
) -> None:
    old = secret(studio)
    with page_of(studio) as page:
        page.hear("welcome")
        assert studio.terminate() == 0
    with Studio(project, tmp_path / "home", command=command(tmp_path)) as again:
        assert again.port == studio.port
        assert again.url != studio.url
        assert get(again, studio.url.split(str(studio.port), 1)[1], {})[0] == 401, "an old address opens it"
        with opened(again, Cookie=old["Cookie"]) as socket:
            assert Page(socket).hear("welcome")["project"] == project.name


def test_the_secret_of_a_project_is_in_no_address_and_opens_no_other_project(
    studio: Studio, project: Path, tmp_path: Path
) -> None:
    old = secret(studio)
    value = old["Cookie"].split("=", 1)[1]
    assert value not in studio.url
    kept = [one for one in (tmp_path / "home").rglob("*.json") if value in one.read_text("utf-8")]
    assert [(one.parent.name, one.stat().st_mode & 0o077) for one in kept] == [("studio", 0)]
    assert studio.terminate() == 0
    other = new_project(tmp_path / "other")
    with Studio(other, tmp_path / "home", port=studio.port, command=command(tmp_path)) as stranger:
        with pytest.raises(InvalidStatus) as refused, opened(stranger, Cookie=old["Cookie"]):
            pass
        assert refused.value.response.status_code == 401


def test_a_port_that_something_else_has_taken_is_left_to_it(
    studio: Studio, project: Path, tmp_path: Path
) -> None:
    assert studio.terminate() == 0
    with closing(socket.socket(socket.AF_INET, socket.SOCK_STREAM)) as stranger:
        stranger.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        stranger.bind(("127.0.0.1", studio.port))
        stranger.listen()
        with Studio(project, tmp_path / "home", command=command(tmp_path)) as again:
            assert again.port != studio.port
            with page_of(again) as page:
                page.hear("welcome")


def test_the_newest_run_is_served_as_files_under_the_same_rules(shared: Studio, tmp_path: Path) -> None:
    with page_of(shared) as page:
        run = page.hear("run", state="done")["id"]
        for ending in ("npz", "inputs.json"):
            status, content = get(shared, f"/run/{run}.{ending}", secret(shared))
            assert status == 200
            (tmp_path / f"x.{ending}").write_bytes(content)
            assert get(shared, f"/run/{run}.{ending}", {})[0] == 401
            assert get(shared, f"/run/{run + 7}.{ending}", secret(shared))[0] == 404
        assert read_recording(tmp_path / "x.npz").duration > 0.0
        assert read_inputs(tmp_path / "x.inputs.json") == Interventions()


def test_cookies_of_other_servers_of_this_machine_do_no_harm(shared: Studio) -> None:
    ours = secret(shared)["Cookie"]
    strangers = "; ".join(f"ropsim-{port}=wrong" for port in range(9000, 9020))
    assert get(shared, "/", {"Cookie": f"{strangers}; {ours}; _xsrf=2|a|b"})[0] == 200
    assert get(shared, "/", {"Cookie": strangers})[0] == 401
    for stranger in (
        {"Origin": "null"},
        {"Origin": f"http://127.0.0.1:{shared.port + 1}"},
        {"Host": f"evil.example:{shared.port}"},
    ):
        with pytest.raises(InvalidStatus), opened(shared, **stranger):
            pass


@pytest.mark.skipif(sys.platform == "win32", reason="a limit of the system that is missing there")
def test_a_full_disk_is_told_and_loses_nothing(project: Path, tmp_path: Path) -> None:
    limited = ("bash", "-c", 'ulimit -f 2000; exec "$@"', "bash", *command(tmp_path))
    text = "# " + "x" * 3_000_000
    with Studio(project, tmp_path / "home", command=limited) as studio, page_of(studio) as page:
        before = (project / MAIN).read_bytes()
        page.hear("welcome")
        page.say(type="edit", document=MAIN, text=text, version=1)
        assert page.hear("notice")["code"] == "U959"
        page.say(type="save", document=MAIN, overwrite=False)
        assert page.hear("notice")["code"] == "U957"
        assert (project / MAIN).read_bytes() == before
        assert list(project.rglob(".ropsim-*")) == []
        with page_of(studio) as second:
            assert second.hear("welcome")["documents"][1]["text"] == text


def test_a_project_folder_that_goes_away_and_comes_back(studio: Studio, project: Path) -> None:
    with page_of(studio) as page:
        page.hear("welcome")
        page.hear("run", state="done")
        page.say(type="edit", document=MAIN, text="# unsaved\n", version=1)
        page.hear("documents")
        project.rename(project.with_name("elsewhere"))
        assert page.hear("notice")["code"] == "U965"
        left = page.hear("documents")
        assert sorted(one["name"] for one in left["documents"]) == ["cell.toml", MAIN]
        assert not project.exists()
        project.with_name("elsewhere").rename(project)
        page.hear("documents")
        page.say(type="revert", document=MAIN)
        page.say(type="run", program="", fidelity="kinematic")
        page.hear("run", state="done")


def test_two_studios_of_one_project_see_each_other(studio: Studio, project: Path, tmp_path: Path) -> None:
    with Studio(project, tmp_path / "home", command=command(tmp_path)) as other:
        with page_of(studio) as page, page_of(other) as theirs:
            page.hear("run", state="done")
            theirs.hear("run", state="done")
            page.say(type="edit", document=MAIN, text="# mine\n", version=1)
            theirs.say(type="edit", document=MAIN, text="# theirs\n", version=1)
            page.say(type="save", document=MAIN, overwrite=False)
            while not theirs.hear("documents")["documents"][0]["conflict"]:
                pass
            theirs.say(type="save", document=MAIN, overwrite=False)
            assert theirs.hear("notice")["code"] == "U956"
            assert (project / MAIN).read_text("utf-8") == "# mine\n"
            wait_for_journal(tmp_path, "theirs")
        other.kill()
    assert studio.terminate() == 0
    with Studio(project, tmp_path / "home", command=command(tmp_path)) as again, page_of(again) as page:
        assert page.hear("welcome")["documents"][1]["text"] == "# theirs\n"


def test_a_slow_reader_of_http_holds_nobody_up(studio: Studio) -> None:
    with closing(http.client.HTTPConnection("127.0.0.1", studio.port)) as slow:
        slow.connect()
        slow.send(b"GET / HTTP/1.1\r\n")  # and never the rest
        assert get(studio, "/", secret(studio))[0] == 200
        assert studio.terminate() == 0
