"""Whatever is edited: a compiler that remembers earlier versions answers as one that has never seen any.

`ROPSIM_EDITS` is the number of edits, 300 unless told; a long run takes 10,000, a quarter of an hour.
"""

import os
import random
from importlib import import_module
from pathlib import Path

import pytest

from ropsim import language
from ropsim.icr import disassemble, program_id
from ropsim.program import check_contracts
from ropsim.program.diagnostics import GRIPPER_STATE
from ropsim.query import is_same
from support.examples import examples
from support.tasks import CELL

EDITS = int(os.environ.get("ROPSIM_EDITS", examples(300)))
FOLDER = Path(__file__).parents[1] / "golden" / "task"
TEXTS = [path.read_text(encoding="utf-8") for path in sorted(FOLDER.glob("*.task"))]
LINES = sorted({line for text in TEXTS for line in text.split("\n")})
WORDS = sorted({word for line in LINES for word in line.split()})
TASK = """task Lift(part: loc, height = 20, n = 2)
  mov part above height
  repeat n
    lin part
    x = height
  endr
endp
"""
FLAT = [
    line
    for k in range(40)
    for line in (
        f"lin (400, {k}, 300) speed {k + 1} mm/s",
        f"x{k % 9} = count + {k}",
        f"if x{k % 9} > {k} then print count",
        f"mov (300, 0, x{k % 9})",
        f"repeat {k % 4}",
        f"  count = count + {'0.5' if k == 30 else 1}",
        "endr",
        "circ via (400, 10, 300) to (400, 20, 300)",
        "lin (400, 10, 300) store seen",
    )
]
"""Control statements without tasks, more than are read as one part."""
PIECES = [
    *LINES,
    *FLAT,
    "count = 0",
    "count = 0.5",
    "x1 = x2",
    "x3 = infeed",
    "stop",
    "for x1 = 1 to 3",
    "load (x, y, z), infeed",
    *TASK.split("\n"),
    "task Lift(part: loc)",
    "task again",
    "endp",
    "end",
    "endr",
    "endif",
    "repeat 2",
    "if part_ok",
    "else",
    "x = 1",
    "x = x + 0.5",
    "var x: int = 3",
    "var y",
    "y = 20 mm",
    "const clear = 12 mm",
    "loc rack = (1, 2, 3)",
    "frame plate = (1, 0, 0)",
    "q = joints(1, 2, 3)",
    "mov joints(1, 2, 3, 4, 5, 6)",
    "if part_ok print 1",
    "  while part_ok open",
    "for x1 = 1 to 3 print x1",
    "repeat 3 times",
    "end if",
    "endproc",
    "loc late = (1, 2, 3)",
    "call Lift 1, 20",
    "Lift infeed",
    "tsak Other",
    "reapet 3",
    "task reapet(n: int)",
    "task reapet(n)",
    "units cm, deg",
    "strict",
    "classic",
    "program other",
    "needs the gripper to be open and the",
    "assumes gripper open at start.",
    "assumes gripper open",
    "needs gripper closed",
    "open",
    "close",
    "lin (1,",
    "x = 1 \\",
    "return 3",
    "set frame pallet",
]


class Typist:
    """Edits a text at random, mostly a little, and often back to what it was."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.lines = list(FLAT) if seed % 2 else self.random.choice(TEXTS).split("\n")
        self.before: list[list[str]] = []

    def edit(self) -> str:
        """Change the text, and return it."""
        chosen = self.random.random()
        if chosen < 0.2 and self.before:
            self.lines = self.before.pop()
        else:
            self.before = [*self.before[-5:], list(self.lines)]
            self._change(chosen)
        return "\n".join(self.lines)

    def _change(self, chosen: float) -> None:
        at = self.random.randrange(len(self.lines))
        line = self.lines[at]
        if chosen < 0.35:
            self.lines.insert(at, self.random.choice(PIECES))
        elif chosen < 0.45:
            del self.lines[at]
            self.lines = self.lines or [""]
        elif chosen < 0.55:
            self.lines[at] = self.random.choice(["", f"{line}  # note", f"  {line}"])
        elif chosen < 0.7:
            words = line.split(" ")
            words[self.random.randrange(len(words))] = self.random.choice(WORDS)
            self.lines[at] = " ".join(words)
        elif chosen < 0.85:
            place = self.random.randrange(len(line) + 1)
            typed = self.random.choice(["", "x", "1", "(", ")", ".", "=", " ", '"'])
            self.lines[at] = line[:place] + typed + line[place + self.random.randrange(2) :]
        elif chosen < 0.9:
            self.lines[at:at] = TASK.split("\n")
        elif chosen < 0.95:
            end = min(at + self.random.randrange(1, 12), len(self.lines))
            moved = self.lines[at:end]
            del self.lines[at:end]
            to = self.random.randrange(len(self.lines) + 1)
            self.lines[to:to] = moved
        else:
            self.lines = self.random.choice(TEXTS).split("\n")


def told(result: language.Compiled) -> dict[str, object]:
    """Return all that a compilation tells."""
    return {
        "findings": result.diagnostics,
        "code": disassemble(result.icr) if result.icr is not None else None,
        "identity": program_id(result.icr) if result.icr is not None else None,
        "structured": result.program,
        "places": result.places,
        "tasks": {name: str(form) for name, form in result.tasks.items()},
    }


@pytest.mark.parametrize("seed", range(4))
def test_earlier_versions_change_no_answer(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    groups = import_module("ropsim.language.questions.groups")  # short texts are to have many of them
    monkeypatch.setattr(groups, "USUAL", 3)
    monkeypatch.setattr(groups, "MOST", 5)
    typist = Typist(seed)
    cache = language.LineCache()
    for _ in range(EDITS // 4):
        text = typist.edit()
        name = typist.random.choice(["t.task", "t.task", "u.task"])
        kept = told(language.compile(text, CELL, name, cache))
        alone = language.compile(text, CELL, name)
        fresh = told(alone)
        for part in fresh:
            assert kept[part] == fresh[part], f"{part} of\n{text}"
        if alone.icr is not None and alone.program is not None:
            contracts = [one for one in alone.diagnostics if one.code == GRIPPER_STATE.code]
            assert contracts == [*dict.fromkeys(check_contracts(alone.program, alone.places))]


@pytest.mark.parametrize("seed", range(2))
def test_code_that_is_asked_for_late_is_that_of_its_own_text(
    seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Code is put together when somebody asks for it: here after later versions, in any order, or never."""
    groups = import_module("ropsim.language.questions.groups")
    monkeypatch.setattr(groups, "USUAL", 3)
    monkeypatch.setattr(groups, "MOST", 5)
    typist = Typist(seed)
    cache = language.LineCache()
    waiting: list[tuple[str, language.Compiled]] = []
    asked = 0
    for _ in range(EDITS // 4):
        text = typist.edit()
        waiting.append((text, language.compile(text, CELL, "t.task", cache)))
        if not waiting[-1][1].ok and typist.before:
            typist.lines = typist.before.pop()
        if typist.random.random() < 0.5:
            text, kept = waiting.pop(typist.random.randrange(len(waiting)))
            alone = language.compile(text, CELL, "t.task").icr
            assert is_same(kept.icr, alone), f"code of\n{text}"
            asked += alone is not None
        waiting = waiting[-8:]
    assert asked > EDITS // 40
