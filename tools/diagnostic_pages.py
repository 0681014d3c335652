"""Write one page per diagnostic code under docs/reference/diagnostics, from the catalogue.

python tools/diagnostic_pages.py           write the pages
python tools/diagnostic_pages.py --check   compare only; exit 1 and name the pages that differ
"""

import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

from ropsim.cli import RETIRED, all_kinds
from ropsim.core import Kind

FOLDER = Path(__file__).parent.parent / "docs" / "reference" / "diagnostics"


class Band(NamedTuple):
    """Codes that begin alike.

    Attributes:
        title: what they are about.
        packages: those that define them.
    """

    title: str
    packages: tuple[str, ...]


_FILES = ("calibration", "cellfile", "meshes", "model", "records", "robots", "tomltext", "userfiles")

BANDS = {
    "L1": Band("Syntax of the task language", ("language",)),
    "N2": Band("Names", ("language", "program")),
    "T3": Band("Types and units", ("language", "program")),
    "I4": Band("ICR and its machine", ("icr", "program")),
    "M5": Band("Motion, kinematics, dynamics", ("dynamics", "kinematics", "motion", "spatial")),
    "C6": Band(
        "Controller",
        (
            "blockdiagram",
            "controller",
            "planning",
        ),
    ),
    "S7": Band("Simulation", ("simulation",)),
    "X8": Band("Projects, cell files, models, recordings", (*_FILES, "workbench")),
    "X9": Band(
        "Robots in files; parts of the library; files and memory of the machine",
        (
            *("cellfile", "core", "exchange", "express", "model", "nirox", "part21", "parts", "robotfile"),
            "workbench",
        ),
    ),
    "U9": Band("Use of the commands", ("cli", "core", "lsp", "studio")),
    "P1": Band("Knowledge bases", ("prolog", "tasks")),
    "W1": Band("Workspaces", ("workspace",)),
}
"""Of each code, by its first two characters."""


def page(kind: Kind) -> str:
    """Return the page of one kind."""
    return (
        f"# {kind.code} {kind.slug}\n\n"
        f"*{kind.severity.value}* · {kind.summary}\n\n"
        f"{kind.explanation}\n\n"
        f"`ropsim explain {kind.code}` prints this page. [All diagnostics](README.md)\n"
    )


def index(kinds: Mapping[str, Kind]) -> str:
    """Return the list of all kinds, by band, and of the codes that are no longer reported."""
    lines = ["# Diagnostics", "", "Made from the catalogue by `make docs`; a code is never used again."]
    for start, band in BANDS.items():
        packages = ", ".join(f"`{name}`" for name in band.packages)
        lines += [
            "",
            f"## {start}xx {band.title}",
            "",
            f"Defined in {packages}.",
            "",
            "| code | found | severity |",
            "|---|---|---|",
        ]
        lines += [
            f"| [{code}]({code}.md) | `{kind.slug}`: {kind.summary} | {kind.severity.value} |"
            for code, kind in kinds.items()
            if code.startswith(start)
        ]
    lines += ["", "## Retired", "", "Codes of earlier versions, which are no longer reported.", ""]
    lines += ["| code | meant | now |", "|---|---|---|"]
    lines += [f"| {code} | `{one.slug}`: {one.meaning} | {one.now} |" for code, one in RETIRED.items()]
    return "\n".join(lines) + "\n"


def pages() -> Mapping[Path, str]:
    """Return every page by path.

    Raises:
        ValueError: a code belongs to no band, or has been retired.
    """
    kinds = all_kinds()
    strays = [code for code in kinds if code[:2] not in BANDS]
    if strays:
        raise ValueError(f"codes outside of all bands: {', '.join(strays)}")
    again = [code for code in kinds if code in RETIRED]
    if again:
        raise ValueError(f"codes that meant something else once: {', '.join(again)}")
    result = {FOLDER / f"{code}.md": page(kind) for code, kind in kinds.items()}
    return {FOLDER / "README.md": index(kinds), **result}


def differences(wanted: Mapping[Path, str]) -> Iterator[str]:
    """Yield what is missing, stale or left over."""
    for path, text in wanted.items():
        if not path.exists():
            yield f"missing: {path.name}"
        elif path.read_text("utf-8") != text:
            yield f"stale: {path.name}"
    yield from (f"left over: {path.name}" for path in sorted(FOLDER.glob("*.md")) if path not in wanted)


def main(arguments: list[str]) -> int:
    """Write or check the pages; return the exit code."""
    wanted = pages()
    if arguments == ["--check"]:
        found = list(differences(wanted))
        print("\n".join([*found, "run `make docs`"]) if found else f"{len(wanted)} pages are up to date")
        return int(bool(found))
    FOLDER.mkdir(parents=True, exist_ok=True)
    left_over = sorted(path for path in FOLDER.glob("*.md") if path not in wanted)
    gone = [path.stem for path in left_over if path.stem not in RETIRED]
    if gone:
        print(f"nothing is written: add to RETIRED of ropsim/cli/retired.py: {', '.join(gone)}")
        return 1
    for path in left_over:
        path.unlink()
    for path, text in wanted.items():
        path.write_text(text, "utf-8")
    print(f"{len(wanted)} pages written")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
