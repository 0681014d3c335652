"""The studio as a real process: start and end, who gets in, one project from page to simulator and back."""

import contextlib
import gzip
import json
import socket
import subprocess
from contextlib import closing
from pathlib import Path

import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus

from support.patience import PATIENCE
from support.studio_client import (
    Lend,
    command,
    connected,
    get,
    opened,
    page_of,
    secret,
    wait_for_journal,
)
from support.studio_family import ends, folders, group, needs_proc
from support.studio_process import Studio


@needs_proc
def test_ctrl_c_ends_server_workers_and_language_server(studio: Studio) -> None:
    with page_of(studio) as page, opened(studio, "/ws/lsp") as language:
        page.hear("welcome")
        language.send('{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}}')
        language.recv(timeout=PATIENCE)
        assert len(group(studio.process.pid)) >= 3
        assert studio.interrupt() == 0
    assert ends(studio.process.pid)
    assert studio.errors() == ""


@needs_proc
def test_a_request_of_the_system_ends_it_too(studio: Studio) -> None:
    assert studio.terminate() == 0
    assert ends(studio.process.pid)
    assert studio.errors() == ""


@needs_proc
@pytest.mark.parametrize("then", ["the project stays", "the project is moved"])
def test_unsaved_text_survives_a_killed_server_and_no_process_does(
    studio: Studio, project: Path, tmp_path: Path, then: str
) -> None:
    with page_of(studio) as page:
        page.hear("welcome")
        page.say(type="edit", document="programs/main.task", text="-- unsaved\n", version=1)
        wait_for_journal(tmp_path, "unsaved")
        studio.kill()
    assert ends(studio.process.pid)
    assert "unsaved" not in (project / "programs" / "main.task").read_text("utf-8")
    if then == "the project is moved":
        project = project.rename(tmp_path / "moved")
    with Studio(project, tmp_path / "home", command=command(tmp_path)) as again, page_of(again) as page:
        documents = {one["name"]: one for one in page.hear("welcome")["documents"]}
        recovered = documents["programs/main.task"]
        assert (recovered["text"], recovered["recovered"]) == ("-- unsaved\n", True)


def test_a_page_sees_the_cell_the_run_and_an_edit_that_is_refused(lent: Studio) -> None:
    with page_of(lent) as page:
        welcome = page.hear("welcome")
        assert (welcome["editing"], welcome["program"]) == (True, "main")
        assert page.hear("scene")["scene"]["stations"][0]["robot"] == "puma560"
        done = page.hear("run", state="done")
        status, pack = get(lent, f"/run/{done['id']}.pack", secret(lent))
        assert (status, gzip.decompress(pack)[:4]) == (200, b"RPK1")
        page.say(type="edit", document="programs/main.task", text="relase\n", version=1)
        refused = page.hear("run", state="refused")
        assert refused["findings"][0]["span"]["source"] == "programs/main.task"
        assert get(lent, f"/run/{refused['id']}.pack", secret(lent))[0] == 404


def test_the_language_server_answers_through_its_socket(bare_studio: Studio, project: Path) -> None:
    with opened(bare_studio, "/ws/lsp") as language:
        language.send('{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}}')
        answer = json.loads(language.recv(timeout=PATIENCE))
        assert (answer["id"], "capabilities" in answer["result"]) == (1, True)
        document = {"uri": (project / "programs" / "main.task").as_uri(), "languageId": "task", "version": 1}
        opening = {"textDocument": {**document, "text": "relase\n"}}
        language.send(json.dumps({"jsonrpc": "2.0", "method": "textDocument/didOpen", "params": opening}))
        while (found := json.loads(language.recv(timeout=PATIENCE))).get(
            "method"
        ) != "textDocument/publishDiagnostics":
            pass
        assert found["params"]["diagnostics"]


def test_strangers_stay_outside(bare_studio: Studio) -> None:
    ours = secret(bare_studio)
    assert get(bare_studio, "/", {})[0] == get(bare_studio, "/assets/index-1a2b3c.js", {})[0] == 200
    for path in ("/run/1.pack", "/run/1.npz", "/told/1.pack", f"/mesh/{'0' * 64}.glb", "/anything"):
        assert get(bare_studio, path, {})[0] == 401
    assert get(bare_studio, "/anything", ours)[0] == 404
    assert get(bare_studio, "/", {**ours, "Host": "evil.example"})[0] == 400
    assert get(bare_studio, "/", ours, "POST")[0] == 403
    assert get(bare_studio, "/assets/../index.html", ours)[0] == 404
    for path in ("/ws/studio", "/ws/lsp"):
        for headers, status in (
            ({"Origin": "https://evil.example"}, 403),
            ({"Origin": ""}, 403),
            ({"Host": "evil.example"}, 400),
        ):
            with pytest.raises(InvalidStatus) as refused, connected(bare_studio, path, **headers):
                pass
            assert refused.value.response.status_code == status
        with pytest.raises(ConnectionClosed) as closed, opened(bare_studio, path, "a key that is not ours"):
            pass
        assert closed.value.rcvd is not None
        assert closed.value.rcvd.code == 4401


def test_the_page_has_a_nonce_of_its_own_each_time(bare_studio: Studio) -> None:
    first, second = (get(bare_studio, "/", {})[1].decode() for _ in range(2))
    assert "__CSP_NONCE__" not in first
    assert first != second


def test_a_message_beyond_all_measure_ends_its_own_socket_only(bare_studio: Studio) -> None:
    with opened(bare_studio) as socket, page_of(bare_studio) as other:
        with contextlib.suppress(ConnectionClosed):  # sooner or later, as the buffers have it
            socket.send("x" * 20_000_000)
        with pytest.raises(ConnectionClosed):
            socket.recv(timeout=PATIENCE)
        other.hear("welcome")


def run(home: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [*command(home), *arguments], capture_output=True, text=True, timeout=PATIENCE, check=False, cwd=home
    )


def test_a_port_that_is_taken_is_told_in_words(project: Path, tmp_path: Path) -> None:
    with closing(socket.socket()) as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        port = other.getsockname()[1]
        said = run(tmp_path, "studio", str(project), f"--port={port}", "--no-browser")
    assert (said.returncode, said.stdout) == (1, "")
    assert "error[U951]" in said.stderr
    assert f"port {port}" in said.stderr


@pytest.mark.parametrize("port", ["-1", "65536", "99999999999"])
def test_a_port_that_cannot_be_is_told_in_words(project: Path, tmp_path: Path, port: str) -> None:
    said = run(tmp_path, "studio", str(project), f"--port={port}", "--no-browser")
    assert said.returncode == 1
    assert "error[U951]" in said.stderr


def test_where_no_project_is_the_command_says_how_to_make_one(tmp_path: Path) -> None:
    said = run(tmp_path, "studio", "--no-browser")
    assert said.returncode == 1
    assert "error[U950]" in said.stderr
    assert "ropsim new" in said.stderr


@pytest.mark.parametrize("cell", [b"[cell\n", b"\xff\xfe\x00", None])
def test_a_broken_project_opens_and_is_shown(lend_bare: Lend, project: Path, cell: bytes | None) -> None:
    if cell is None:
        (project / "cell.toml").unlink()
    else:
        (project / "cell.toml").write_bytes(cell)
    with page_of(lend_bare(project)) as page:
        names = [one["name"] for one in page.hear("welcome")["documents"]]
        assert "programs/main.task" in names
        scene = page.hear("scene")
        assert scene["scene"] is None
        assert scene["findings"]
        assert page.hear("run", state="refused")["findings"]


TRAPS = (
    "cell.py",
    "conftest.py",
    "sitecustomize.py",
    "usercustomize.py",
    "numpy.py",
    "typing.py",
    "ropsim.py",
)
TRAPS_OF_CHILDREN = ("multiprocessing.py", "signal.py", "json.py", "starlette.py", "controllers/evil.py")


def test_no_code_of_a_project_runs_whatever_is_done_with_it(project: Path, tmp_path: Path) -> None:
    mark = tmp_path / "mark"
    (project / "controllers").mkdir()
    for name in (*TRAPS, *TRAPS_OF_CHILDREN):
        (project / name).write_text(f"open({str(mark)!r}, 'a').write({name!r})\n", "utf-8")
    for words in (["check", "."], ["run", ".", "--kinematic"], ["icr", "compile", "."]):
        done = subprocess.run(
            [*command(tmp_path), *words],
            cwd=project,
            capture_output=True,
            text=True,
            check=False,
            timeout=PATIENCE,
        )
        assert done.returncode == 0, done.stderr
    home = tmp_path / "home"
    with Studio(project, home, command=command(tmp_path), cwd=project) as studio, page_of(studio) as page:
        assert "controllers/evil.py" in page.hear("welcome")["trust"]["code"]
        page.hear("run", state="done")
        with opened(studio, "/ws/lsp") as language:
            language.send('{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}}')
            language.recv(timeout=PATIENCE)
        if Path("/proc/self/stat").exists():
            places = folders(studio.process.pid)
            assert places
            assert project not in places
    assert not mark.exists(), mark.read_text("utf-8")
