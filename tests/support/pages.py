"""Pages that say what to type: every step of a page, in the order in which it stands there.

The first line of a fenced block says what a step is:

- `toml file=PATH`, `task file=PATH`, `python file=PATH`: the whole of a file; `append=PATH` instead: what
  comes at its end;
- `diff edit=PATH`: lines of a file, each behind a blank, `-` for a line that goes or `+` for a new one;
- `console`: commands behind `$ `, each followed by what it prints; a last line `…` stands for the rest;
- `task` alone: a program that compiles in the cell of the project that the page has made last, with no
  findings but those that its comments name (`# error: T301`);
- `python` alone: statements, carried out one block after the other;
- every other language is only shown.
"""

import re
from dataclasses import dataclass
from pathlib import Path

_FENCE = re.compile(r"^```(\w+)(?: (file|append|edit)=(\S+))?\n(.*?)^```$", re.MULTILINE | re.DOTALL)


@dataclass(frozen=True, slots=True)
class Step:
    """One fenced block of a page.

    Attributes:
        page: file name of the page.
        line: of the page where the text begins.
        language: first word behind the fence.
        mode: `file`, `append`, `edit` or empty.
        path: of the file that it writes, adds to or edits; empty without one.
        text: what stands between the fences.
    """

    page: str
    line: int
    language: str
    mode: str
    path: str
    text: str

    def __str__(self) -> str:
        return f"{self.page}:{self.line}"


def steps(page: Path) -> list[Step]:
    """Return all fenced blocks of a page that name a language."""
    text = page.read_text("utf-8")
    return [
        Step(page.name, text.count("\n", 0, one.start(4)) + 1, one[1], one[2] or "", one[3] or "", one[4])
        for one in _FENCE.finditer(text)
    ]


def write(step: Step, folder: Path) -> None:
    """Write, extend or edit the file of a step below a folder."""
    path = folder / step.path
    path.parent.mkdir(parents=True, exist_ok=True)
    before = "" if step.mode == "file" else path.read_text("utf-8") if path.exists() else ""
    path.write_text(edited(before, step) if step.mode == "edit" else before + step.text, "utf-8")


def edited(before: str, step: Step) -> str:
    """Return a text after the edit of a `diff` step; each group of lines must occur in it exactly once.

    Groups are separated by a line `@@`.
    """
    text = before
    for group in re.split(r"^@@\n", step.text, flags=re.MULTILINE):
        lines = group.splitlines(keepends=True)
        assert all(line[0] in " +-" for line in lines), f"{step}: a line begins with a blank, + or -"
        old = "".join(line[1:] for line in lines if line[0] != "+")
        new = "".join(line[1:] for line in lines if line[0] != "-")
        assert old, f"{step}: a group needs a line of the file"
        assert text.count(old) == 1, f"{step}: found {text.count(old)} times in {step.path}:\n{old}"
        text = text.replace(old, new)
    return text


ELLIPSIS = "…"


def commands(step: Step) -> list[tuple[str, list[str]]]:
    """Return the commands of a `console` step, each with the lines that the page shows below it."""
    parts = re.split(r"^\$ (.+)\n", step.text, flags=re.MULTILINE)
    assert parts[0] == "", f"{step}: a command stands first"
    return [(parts[at], parts[at + 1].splitlines()) for at in range(1, len(parts), 2)]


def as_far_as_shown(printed: list[str], shown: list[str]) -> list[str]:
    """Return what a command printed as the page would show it: as many lines, the rest as `…`."""
    if not shown or shown[-1] != ELLIPSIS:
        return printed
    return [*printed[: len(shown) - 1], ELLIPSIS]


def with_output(page: str, step: Step, outputs: list[list[str]]) -> str:
    """Return the text of a page with other outputs in one of its `console` steps."""
    fresh = "".join(
        "\n".join([f"$ {words}", *output]) + "\n"
        for (words, _), output in zip(commands(step), outputs, strict=True)
    )
    assert page.count(step.text) >= 1
    return page.replace(f"```console\n{step.text}```", f"```console\n{fresh}```", 1)
