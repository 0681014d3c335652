"""Whatever is done to a project in whatever order: what is kept answers as what has never seen any of it.

A machine edits texts, exchanges cell files, forgets texts, and lets processes end and begin: between them
only the cache folder stays, sometimes damaged.
"""

import tempfile
from pathlib import Path

from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, rule

from ropsim.core import KeptFiles, SourceText
from ropsim.query import is_same
from ropsim.workbench import Workspace
from ropsim.workbench.testing import questions
from support.examples import examples

CELL = """[cell]
name = "c"
program = "main"
[robot]
model = "puma560"
[locations.bin]
position = [300, 200, 500]
"""
CELLS = [
    CELL,
    f"{CELL}# a comment\n",
    CELL.replace("300", "310"),
    CELL.replace("bin", "rack"),
    f"{CELL}wrong",
]
LINES = [
    "program p",
    "units mm, deg",
    "strict",
    "classic",
    "",
    "# a comment",
    "mov bin",
    "mov rack above 20",
    "lin (400, 100, 300)",
    "lin (400, 100, high)",
    "lin (400 kg, 100, 300)",
    "mov joints(0, 60, -150, 0, -60, 0) store seen",
    "const high = 300 mm",
    "var x: int = 3",
    "x = 1",
    "x = x + 0.5",
    "y = high * 2",
    "task Lift(part: loc, by)",
    "task Lift",
    "mov part above by",
    "endp",
    "end",
    "repeat 2",
    "endr",
    "if x > 2",
    "Lift bin, 20",
    "Lift",
    "call Lift 1",
    "return 3",
    "wait 1 s",
    "waite 1 s",
]
NAMES = ["main.task", "other.task", "code.icr"]
START = ["program p", "mov bin"]
PLACE = st.integers(0, 12)
PADDING = "\n" * questions.LEAST_LINES
"""So that each text is long enough to be kept."""


class Edited(RuleBasedStateMachine):
    """A project of a few texts, and the workspace that has seen all that was done to it."""

    @initialize()
    def begin(self) -> None:
        self.folder = tempfile.TemporaryDirectory()
        self.answers = Path(self.folder.name) / "kept"
        self.kept = KeptFiles("kept", 64_000_000, 16_000_000, lambda: Path(self.folder.name))
        self.workspace = Workspace(self.kept)
        self.lines = {name: list(START) for name in NAMES}
        self.cell = CELL
        self.shown = NAMES[0]

    @rule(name=st.sampled_from(NAMES), place=PLACE, line=st.sampled_from(LINES))
    def insert(self, name: str, place: int, line: str) -> None:
        self.lines[name].insert(min(place, len(self.lines[name])), line)
        self.shown = name

    @rule(name=st.sampled_from(NAMES), place=PLACE, line=st.sampled_from(LINES))
    def exchange(self, name: str, place: int, line: str) -> None:
        if self.lines[name]:
            self.lines[name][place % len(self.lines[name])] = line
        self.shown = name

    @rule(name=st.sampled_from(NAMES), place=PLACE, count=st.integers(1, 5))
    def delete(self, name: str, place: int, count: int) -> None:
        del self.lines[name][place : place + count]
        self.shown = name

    @rule(name=st.sampled_from(NAMES), place=PLACE, count=st.integers(1, 5), to=PLACE)
    def move(self, name: str, place: int, count: int, to: int) -> None:
        moved = self.lines[name][place : place + count]
        del self.lines[name][place : place + count]
        self.lines[name][to:to] = moved
        self.shown = name

    @rule(cell=st.sampled_from(CELLS))
    def exchange_cell(self, cell: str) -> None:
        self.cell = cell

    @rule(name=st.sampled_from(NAMES))
    def forget(self, name: str) -> None:
        self.workspace.forget(name)

    @rule()
    def end_and_begin(self) -> None:
        self.workspace.keep()
        self.workspace = Workspace(self.kept)

    @rule(place=st.integers(0, 10_000), value=st.integers(0, 255))
    def damage(self, place: int, value: int) -> None:
        for path in self.answers.iterdir() if self.answers.is_dir() else ():
            content = bytearray(path.read_bytes())
            content[place % len(content)] = value
            path.write_bytes(content)

    @invariant()
    def the_answers_are_those_of_a_new_workspace(self) -> None:
        if hasattr(self, "shown"):
            text = SourceText(self.shown, "\n".join(self.lines[self.shown]) + PADDING)
            assert is_same(self.told(self.workspace, text), self.told(Workspace(), text)), text.text

    def told(self, workspace: Workspace, text: SourceText) -> object:
        """Return all that is told of a text."""
        cell = SourceText("cell.toml", self.cell)
        read = workspace.cell(cell, "c")
        at = workspace.at(cell if read.cell is not None else None, "c", "")
        code_id = workspace.code_id(text, at) if text.name.endswith(".task") else ""
        outside = frozenset(read.cell.locations) if read.cell is not None else frozenset[str]()
        return (
            read.diagnostics,
            workspace.checked(text, {"": at}),
            workspace.compiled(text, at),
            code_id,
            workspace.outline(text),
            workspace.uses(text, outside).found,
        )

    def teardown(self) -> None:
        if hasattr(self, "folder"):
            self.folder.cleanup()


Edited.TestCase.settings = settings(max_examples=examples(8), stateful_step_count=25, deadline=None)
TestEdits = Edited.TestCase
