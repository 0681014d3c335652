"""What the server tells of the open texts of a project is what `ropsim check` tells of the project."""

import os
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from ropsim.lsp.testing import Document
from ropsim.workbench import new_project, open_project
from support.editors import Editor, uri_of
from support.robot_files import TWO_JOINTS

ROOT = Path(__file__).parents[3]
ENDINGS = (".toml", ".task", ".icr")


def checked(folder: Path) -> list[tuple[str, str, str]]:
    """Return file, code and range of what compiling finds; what has no place stands at the cell file."""
    told = []
    for one in open_project(folder).compile().diagnostics:
        path = Path(one.span.source) if one.span is not None else folder / "cell.toml"
        place = Document(uri_of(path), 1, path.read_text("utf-8")).range_of(one.span)
        told.append((path.name, one.code, str(place)))
    return sorted(told)


def published(folder: Path) -> list[tuple[str, str, str]]:
    editor = Editor()
    for path in (one for one in sorted(folder.rglob("*")) if one.suffix in ENDINGS and one.is_file()):
        text = path.read_bytes().decode("utf-8", "ignore")
        document = {"uri": uri_of(path), "text": text, "version": 1}
        if path.suffix == ".toml" or path.read_bytes().decode("latin-1").isascii():
            editor.tell("textDocument/didOpen", textDocument=document)
    return sorted(
        (Path(uri).name, one["code"], str(one["range"]))
        for uri, findings in editor.settle().items()
        for one in findings
    )


def rewrite(name: str, old: str, new: str) -> Callable[[Path], None]:
    def change(folder: Path) -> None:
        text = (folder / name).read_text("utf-8")
        assert old in text
        (folder / name).write_text(text.replace(old, new), "utf-8")

    return change


def write(name: str, content: bytes) -> Callable[[Path], None]:
    def change(folder: Path) -> None:
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(content)

    return change


def both(first: Callable[[Path], None], second: Callable[[Path], None]) -> Callable[[Path], None]:
    def change(folder: Path) -> None:
        first(folder)
        second(folder)

    return change


def without_programs(folder: Path) -> None:
    shutil.rmtree(folder / "programs")


def with_link(folder: Path) -> None:
    (folder / "programs" / "other.task").symlink_to("nowhere")


def with_pipe(folder: Path) -> None:
    os.mkfifo(folder / "programs" / "other.task")


def with_robot(folder: Path) -> None:
    write("robots/arm.toml", TWO_JOINTS.replace("limits", "lmits", 1).encode())(folder)
    rewrite("cell.toml", 'model = "puma560"', 'model = "robots/arm.toml"')(folder)


def with_two_stations(folder: Path) -> None:
    cell = '[stations.left]\nrobot = "puma560"\nprogram = "mian"\n\n[stations.right]\nrobot = "scara"\n'
    write("cell.toml", cell.encode())(folder)
    write("programs/both.task", b"program both\nunits mm\nmov joints(1, 2)\n")(folder)


BYTES = "programs/other.task", b"program other\nprint \xff\n"
SYNTAX = "programs/other.task", b"program other\nlin (1, 2\nlin nowhere\n"
NAMES = "programs/main.task", "infeed", "infed"
CELL = "cell.toml", "[robot]", "[robo]"
CHANGES: dict[str, Callable[[Path], None]] = {
    "nothing": rewrite("programs/main.task", "infeed", "infeed"),
    "names": rewrite(*NAMES),
    "unused": write("programs/other.task", b"program other\nn = 3\n"),
    "signal": write("programs/other.task", b"program other\nsignal lamp = output 7\nset lamp on\n"),
    "code text": write("programs/other.icr", b"ICR 1.0 other\nPROC main\n  JUMP\nEND\n"),
    "no such program": rewrite("cell.toml", 'program = "main"', 'program = "mian"'),
    "no program": without_programs,
    "link": with_link,
    "pipe": with_pipe,
    "bytes": write(*BYTES),
    "bytes and names": both(write(*BYTES), rewrite(*NAMES)),
    "code": write("laws/mine.py", b"import os\n"),
    "cell": rewrite(*CELL),
    "cell and syntax": both(write(*SYNTAX), rewrite(*CELL)),
    "robot": with_robot,
    "stations": with_two_stations,
}
"""What is wrong with a project, by a few words."""


@pytest.mark.parametrize("name", CHANGES)
def test_the_server_tells_what_check_tells(tmp_path: Path, name: str) -> None:
    folder = new_project(tmp_path / "cell", "palletizing")
    CHANGES[name](folder)
    found = checked(folder)
    assert published(folder) == found
    assert (name == "nothing") == (not found)
