"""The studio under pages that misbehave, and with files that do."""

import contextlib
import hmac
import http.client
import json
import re
import shutil
import socket
import sys
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus

from ropsim.core import frozen_dataclass
from ropsim.flow import Interventions
from ropsim.records import read_inputs, read_recording
from ropsim.workbench import new_project
from support.patience import PATIENCE, until
from support.studio_client import (
    Page,
    command,
    connected,
    entered,
    get,
    key_of,
    leave_for,
    opened,
    page_of,
    secret,
    wait_for_journal,
)
from support.studio_family import gone, language_servers, needs_proc, workers
from support.studio_launcher import MOST_LANGUAGE_SERVERS
from support.studio_process import Studio, own_port

pytestmark = pytest.mark.slow

MAIN = "programs/main.task"
CLOSED = b"\x88\x02" + (1013).to_bytes(2, "big")
"""The frame that closes a socket with the words: try again later."""


@frozen_dataclass
class Ended:
    """A studio that has come to its end: what it was, and the user's folders as it left them."""

    project: Path
    home: Path
    port: int
    url: str
    key: str


@pytest.fixture(scope="module")
def once(tmp_path_factory: pytest.TempPathFactory) -> Ended:
    """Return a studio that a page had open, after its end."""
    place = tmp_path_factory.mktemp("once")
    project, home = new_project(place / "cell"), place / "home"
    with Studio(project, home, own_port(), command=command(place)) as studio:
        with connected(studio) as socket:
            key = entered(studio, socket)["key"]
        with page_of(studio) as page:
            page.hear("welcome")
            assert studio.terminate() == 0
    return Ended(project, home, studio.port, studio.url, key)


@pytest.fixture
def ended(once: Ended, tmp_path: Path) -> Ended:
    """Return it with a copy of the user's folders, for the next studio."""
    return replace(once, home=Path(shutil.copytree(once.home, tmp_path / "home")))


def test_nonsense_of_every_kind_is_told_and_the_page_goes_on(bare_studio: Studio) -> None:
    with page_of(bare_studio) as page:
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
    assert bare_studio.errors() == ""


def test_a_tab_that_never_reads_is_dropped_and_holds_nobody_up(lent: Studio) -> None:
    with page_of(lent) as page:
        page.hear("run", state="done")
        with closing(deaf_socket(lent)) as deaf:
            for version in range(1, 27):  # 104 MB: more than may wait for a tab and the system holds for it
                page.say(type="edit", document=MAIN, text=f"# {version}" + " " * 4_000_000, version=version)
            page.say(type="save", document="programs/none.task", overwrite=False)
            assert page.hear("notice")["code"] == "U958"
            assert resident(lent.process.pid) < 400
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
        "Connection: Upgrade",
        "Upgrade: websocket",
        "Sec-WebSocket-Version: 13",
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==",
    )
    deaf.sendall("\r\n".join((*lines, "", "")).encode())
    heard = b""
    while not (challenge := re.search(rb'"nonce":"([\w-]+)"', heard)):
        heard += deaf.recv(1000)
    assert heard.startswith(b"HTTP/1.1 101")
    nonce = challenge[1].decode()
    code = hmac.digest(key_of(studio).encode(), f"{nonce} {studio.port}".encode(), "sha256").hex()
    for message in ({"type": "enter", "answer": code}, {"type": "hello", "tab": "deaf"}):
        text = json.dumps(message).encode()
        assert len(text) < 126
        deaf.sendall(bytes([0x81, 0x80 | len(text)]) + bytes(4) + text)  # masked with zeros
    return deaf


def resident(pid: int) -> float:
    """Return the memory of a process [MB]; 0 where it cannot be told."""
    with contextlib.suppress(OSError):  # there is no such place, or the process has just ended
        text = Path(f"/proc/{pid}/status").read_text("utf-8")
        line = next((one for one in text.splitlines() if one.startswith("VmRSS")), "VmRSS: 0 kB")
        return int(line.split()[1]) / 1e3
    return 0.0


@needs_proc
def test_many_tabs_share_few_language_servers_and_a_storm_leaves_none(bare_studio: Studio) -> None:
    with contextlib.ExitStack() as stack:
        first = stack.enter_context(page_of(bare_studio))  # the tab that edits, if one has been here lately
        pages = [first, *(Page(stack.enter_context(opened(bare_studio)), f"{n}") for n in range(1, 20))]
        assert sum(page.hear("welcome")["editing"] for page in pages) == 1
        languages = [
            stack.enter_context(opened(bare_studio, "/ws/lsp")) for _ in range(MOST_LANGUAGE_SERVERS)
        ]
        for language in languages:
            language.send('{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}}')
            language.recv(timeout=PATIENCE)
        with pytest.raises(InvalidStatus), opened(bare_studio, "/ws/lsp"):
            pass
        assert len(language_servers(bare_studio.process.pid)) == MOST_LANGUAGE_SERVERS
        for page in pages:
            page.hear("run", state="done")
    for _ in range(30):
        with opened(bare_studio):
            pass
    assert gone(language_servers(bare_studio.process.pid))
    until(lambda: len(workers(bare_studio.process.pid)) == 2, "the workers of one project")
    with page_of(bare_studio) as page:
        page.hear("welcome")


def test_odd_addresses_are_not_found(bare_studio: Studio) -> None:
    ours = secret(bare_studio)
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
        assert get(bare_studio, path, ours)[0] == 404, path


def test_the_next_studio_of_a_project_takes_the_open_page_back(ended: Ended, tmp_path: Path) -> None:
    with Studio(ended.project, ended.home, command=command(tmp_path)) as again:
        assert again.port == ended.port
        assert again.url != ended.url
        with pytest.raises(ConnectionClosed), opened(again, key=ended.url.partition("#token=")[2]):
            pass  # an old address does not open it
        with opened(again, key=ended.key) as socket:
            assert Page(socket).hear("welcome")["project"] == ended.project.name


def test_the_secret_of_a_project_is_in_no_address_and_opens_no_other_project(
    ended: Ended, tmp_path: Path
) -> None:
    value = ended.key
    assert value not in ended.url
    kept = [one for one in ended.home.rglob("*.json") if value in one.read_text("utf-8")]
    assert [(one.parent.name, one.stat().st_mode & 0o077) for one in kept] == [("studio", 0)]
    other = new_project(tmp_path / "other")
    with (
        Studio(other, ended.home, port=ended.port, command=command(tmp_path)) as stranger,
        pytest.raises(ConnectionClosed),
        opened(stranger, key=ended.key),
    ):
        pass


def test_a_port_that_something_else_has_taken_is_left_to_it(ended: Ended, tmp_path: Path) -> None:
    with closing(socket.socket(socket.AF_INET, socket.SOCK_STREAM)) as stranger:
        stranger.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        stranger.bind(("127.0.0.1", ended.port))
        stranger.listen()
        with Studio(ended.project, ended.home, command=command(tmp_path)) as again:
            assert again.port != ended.port
            with page_of(again) as page:
                page.hear("welcome")


def test_the_newest_run_is_served_as_files_under_the_same_rules(bare_studio: Studio, tmp_path: Path) -> None:
    with page_of(bare_studio) as page:
        run = page.hear("run", state="done")["id"]
        for ending in ("npz", "inputs.json"):
            status, content = get(bare_studio, f"/run/{run}.{ending}", secret(bare_studio))
            assert status == 200
            (tmp_path / f"x.{ending}").write_bytes(content)
            assert get(bare_studio, f"/run/{run}.{ending}", {})[0] == 401
            assert get(bare_studio, f"/run/{run + 7}.{ending}", secret(bare_studio))[0] == 404
        assert read_recording(tmp_path / "x.npz").duration > 0.0
        assert read_inputs(tmp_path / "x.inputs.json") == Interventions()


def test_no_answer_sets_a_cookie_and_none_is_read(bare_studio: Studio) -> None:
    """Browsers send cookies to every server of this machine, whatever its port."""
    with page_of(bare_studio) as page:
        run = page.hear("run", state="done")["id"]
    ours = secret(bare_studio)
    ticket, cookie = ours["Authorization"], f"ropsim-{bare_studio.port}={key_of(bare_studio)}"
    for path in ("/", "/assets/index-1a2b3c.js", f"/run/{run}.pack", f"/run/{run}.npz", "/nowhere"):
        for headers in ({}, ours, {"Cookie": cookie}, {"Cookie": ticket}, {"Authorization": "Bearer x"}):
            with closing(http.client.HTTPConnection("127.0.0.1", bare_studio.port)) as connection:
                connection.request("GET", path, headers=headers)
                answer = connection.getresponse()
                content = answer.read()
            assert answer.getheader("set-cookie") is None
            assert answer.getheader("referrer-policy") == "no-referrer"
            is_open = path == "/" or path.startswith("/assets/")
            assert (answer.status == 401) == (not is_open and headers != ours)
            assert key_of(bare_studio).encode() not in content
    for stranger in (
        {"Origin": "null"},
        {"Origin": f"http://127.0.0.1:{bare_studio.port + 1}"},
        {"Host": f"evil.example:{bare_studio.port}"},
    ):
        with pytest.raises(InvalidStatus), connected(bare_studio, **stranger):
            pass


def test_what_a_stranger_on_a_port_of_the_studio_hears_opens_no_studio(bare_studio: Studio) -> None:
    """It asks for answers to challenges of its own, and hands on those of a studio on another port."""
    with connected(bare_studio) as socket:
        nonce = json.loads(socket.recv(timeout=PATIENCE))["nonce"]
        elsewhere = f"{nonce} {bare_studio.port + 1}".encode()  # the page knows on which port it is
        heard = hmac.digest(key_of(bare_studio).encode(), elsewhere, "sha256").hex()
        socket.send(json.dumps({"type": "enter", "answer": heard}))
        with pytest.raises(ConnectionClosed):
            socket.recv(timeout=PATIENCE)
    older = hmac.digest(key_of(bare_studio).encode(), f"{nonce} {bare_studio.port}".encode(), "sha256")
    with connected(bare_studio) as socket:
        socket.recv(timeout=PATIENCE)
        socket.send(json.dumps({"type": "enter", "answer": older.hex()}))
        with pytest.raises(ConnectionClosed):
            socket.recv(timeout=PATIENCE)


@pytest.mark.parametrize(
    "first", ["", "[" * 100_000, '{"type":"hello","tab":"a"}', '{"type":"enter"}', b"\xff"]
)
def test_nobody_is_heard_before_entering(bare_studio: Studio, first: str | bytes) -> None:
    for path in ("/ws/studio", "/ws/lsp"):
        with connected(bare_studio, path) as socket:
            socket.recv(timeout=PATIENCE)
            socket.send(first)
            with pytest.raises(ConnectionClosed) as closed:
                socket.recv(timeout=PATIENCE)
            assert closed.value.rcvd is not None
            assert closed.value.rcvd.code == 4401
    assert bare_studio.errors() == ""


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


def test_a_project_folder_that_goes_away_and_comes_back(lent: Studio, project: Path) -> None:
    with page_of(lent) as page:
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


def test_two_studios_of_one_project_see_each_other(lent: Studio, project: Path, tmp_path: Path) -> None:
    with Studio(project, lent.home, command=command(tmp_path)) as other:
        with page_of(lent) as page, page_of(other) as theirs:
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
            wait_for_journal(lent.home, "theirs")
        other.kill()
    leave_for(lent, new_project(tmp_path / "other"))
    with Studio(project, lent.home, command=command(tmp_path)) as again, page_of(again) as page:
        assert page.hear("welcome")["documents"][1]["text"] == "# theirs\n"


def test_a_slow_reader_of_http_holds_nobody_up(studio: Studio) -> None:
    with closing(http.client.HTTPConnection("127.0.0.1", studio.port)) as slow:
        slow.connect()
        slow.send(b"GET / HTTP/1.1\r\n")  # and never the rest
        assert get(studio, "/", {})[0] == 200
        assert studio.terminate() == 0
