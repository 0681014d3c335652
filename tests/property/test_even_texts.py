"""Texts of one character, and of right or wrong lines: every reader and request takes linear work of them.

Work is counted in calls of functions. That misses what a pattern does inside of one call, so patterns are
held to a rule of their own: one that begins anew on each line of a text stays on that line.
"""

import ast
import re
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import partial
from pathlib import Path

import pytest

import ropsim
from ropsim import icr, language, robots
from ropsim.calibration import read_trace
from ropsim.cellfile import read_cell
from ropsim.core import RopsimError, SourceText
from ropsim.language.testing import cuts, kinds_of
from ropsim.lsp.testing import REQUESTS
from ropsim.records import read_inputs
from ropsim.workbench import read_robot
from ropsim.workbench.testing import declared_tasks
from ropsim.workspace import read_points
from support.editors import Editor, place, uri_of
from support.work import calls_of

SIZE = 500
"""Characters; the same again is read for comparison."""
FEW = 250
"""Lines, for the same purpose: each takes the work of many characters."""
LARGE = 10_000
LINES = 2_000
MOST = 2.5
"""Work of twice the text: twice the work, and what lists and tables do when they grow."""
LITTLE = 3_000
"""Calls that any text may take."""

CHARACTERS = "\n\t (\"'x1-#%._[{\\/,:=<&"
RIGHT = {
    "task": "mov home\n",
    "cell.toml": "# a comment\n",
    "robot.toml": "# a comment\n",
    "robot.urdf": "<!-- a comment -->\n",
    "robot.xacro": "<!-- a comment -->\n",
    "robot.xml": "<!-- a comment -->\n",
    "robot.sdf": "<!-- a comment -->\n",
    "robot.stp": "/* a comment */\n",
    "icr": "; a comment\n",
    "points.csv": "100, 200, 300\n",
    "trace.csv": "0.1, 0, 0, 0, 0, 0, 0\n",
    "inputs.json": " \n",
    "tasks.pl": "task(a, []).\n",
    "fmt": "mov home\n",
}
WRONG = "x=\n"

JOINTS = robots.load("puma560").joints


def _inputs(text: str, folder: Path) -> None:
    (folder / "inputs.json").write_text(text, "utf-8")
    with suppress(RopsimError):
        read_inputs(folder / "inputs.json")


def _robot(ending: str) -> Callable[[str, Path], object]:
    return lambda text, _: read_robot(SourceText(f"r.{ending}", text))


READERS: dict[str, Callable[[str, Path], object]] = {
    "task": lambda text, _: language.compile(text),
    "fmt": lambda text, _: language.formatted(text),
    "icr": lambda text, _: icr.read_text(text, "a.icr"),
    "cell.toml": lambda text, _: read_cell(SourceText("cell.toml", text), "c"),
    "points.csv": lambda text, _: read_points(SourceText("p.csv", text)),
    "trace.csv": lambda text, _: read_trace(text.encode(), JOINTS, "t.csv"),
    "inputs.json": _inputs,
    "tasks.pl": lambda text, _: declared_tasks([SourceText("a.pl", text)]),
    **{f"robot.{ending}": _robot(ending) for ending in ("toml", "urdf", "xacro", "xml", "sdf", "stp")},
}


def once_and_twice(unit: str) -> tuple[str, str]:
    """Return a text of a character or a line again and again, and one that is twice as long."""
    text = unit * (SIZE if len(unit) == 1 else FEW)
    return text, text + text


@pytest.mark.parametrize("reader", READERS)
def test_a_reader_takes_linear_work_of_even_texts(reader: str, tmp_path: Path) -> None:
    read = READERS[reader]
    for unit in (*CHARACTERS, RIGHT[reader], WRONG):
        once, twice = (calls_of(partial(read, text, tmp_path)) for text in once_and_twice(unit))
        assert twice <= max(MOST * once, LITTLE), repr(unit)


@pytest.mark.parametrize("reader", READERS)
def test_a_reader_answers_long_even_texts(reader: str, tmp_path: Path) -> None:
    for unit in CHARACTERS:
        READERS[reader](unit * LARGE, tmp_path)
    for unit in (RIGHT[reader], WRONG):
        READERS[reader](unit * LINES, tmp_path)


def test_the_form_of_a_text_of_wrong_lines_is_the_text() -> None:
    text = "program a\n" + WRONG * 201
    assert language.formatted(text) == text


NAMES = ("main.task", "cell.toml", "tasks.pl", "robots/r.toml")


def opened(editor: Editor, text: str, folder: Path, name: str) -> str:
    """Open a text as a file of a project and return its URI."""
    uri = uri_of(folder / name)
    editor.open(uri, text)
    return uri


def asked(editor: Editor, uri: str, method: str, text: str) -> object:
    line = text.count("\n")
    end = place(line, len(text) - text.rfind("\n") - 1)
    whole = {"start": place(0, 0), "end": end}
    more = {"newName": "other", "previousResultId": "1", "query": "a"}
    return editor.ask(method, textDocument={"uri": uri}, position=end, range=whole, **more)


@pytest.mark.parametrize("name", NAMES)
def test_a_request_takes_linear_work_of_even_texts(name: str, tmp_path: Path) -> None:
    editor = Editor()  # one for all texts, as Prolog starts with it; each text is in a project of its own
    for number, unit in enumerate((*'\n ("x1-#%', RIGHT["task"], WRONG)):
        work: list[dict[str, int]] = []
        for text in once_and_twice(unit):
            uri = opened(editor, text, tmp_path / f"{number}" / f"{len(work)}", name)
            asked(editor, uri, "textDocument/documentSymbol", text)
            work.append({method: calls_of(partial(asked, editor, uri, method, text)) for method in REQUESTS})
            editor.tell("textDocument/didClose", textDocument={"uri": uri})
        for method, once in work[0].items():
            assert work[1][method] <= max(MOST * once, LITTLE), (repr(unit), method)


def test_a_selection_of_blank_lines_is_answered(tmp_path: Path) -> None:
    text = "program p\nmov home\n" + "\n" * LINES + "mov home\n"
    editor = Editor()
    uri = opened(editor, text, tmp_path, "main.task")
    assert isinstance(asked(editor, uri, "textDocument/codeAction", text), list)


def patterns() -> Iterator[tuple[str, str]]:
    """Yield the patterns of the sources that look at each line of a text, with their places."""
    for path in sorted(Path(ropsim.__file__).parent.rglob("*.py")):
        source = path.read_text("utf-8")
        if "MULTILINE" not in source:
            continue
        for node in ast.walk(ast.parse(source)):
            if not isinstance(node, ast.Call) or "MULTILINE" not in ast.unparse(node):
                continue
            if node.args and isinstance(node.args[0], ast.Constant | ast.JoinedStr):
                yield f"{path.name}:{node.lineno}", ast.unparse(node.args[0])


def test_a_pattern_that_begins_on_each_line_stays_on_it() -> None:
    """Blanks behind the begin of a line, line ends included, are all that follow: n² characters."""
    found = list(patterns())
    assert len(found) > 3
    assert [place for place, text in found if re.search(r"\^\(*(?:\?:)?\\+s[*+]", text)] == []


def test_a_text_is_cut_without_a_look_at_all_further_lines(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    looked: list[int] = []

    class Watched:
        def search(self, kinds: bytes, begin: int, end: int) -> re.Match[bytes] | None:
            found = notable.search(kinds, begin, end)
            looked.append((found.end() if found is not None else end) - begin)
            return found

    notable = cuts._NOTABLE
    monkeypatch.setattr(cuts, "_NOTABLE", Watched())
    lines = ["mov home"] * LINES
    cuts.cuts(lines, kinds_of(lines), 0, LINES)
    assert 0 < sum(looked) <= cuts.ENOUGH * LINES
