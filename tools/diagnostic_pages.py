"""Write one page per diagnostic code under docs/reference/diagnostics, from the catalogue.

python tools/diagnostic_pages.py           write the pages
python tools/diagnostic_pages.py --check   compare only; exit 1 and name the pages that differ
"""

import sys
from collections.abc import Iterator, Mapping
from pathlib import Path

from ropsim.cli import all_kinds
from ropsim.core import Kind

FOLDER = Path(__file__).parent.parent / "docs" / "reference" / "diagnostics"

BANDS = {
    "L1": "Syntax of the task language",
    "N2": "Names",
    "T3": "Types and units",
    "I4": "ICR and its machine",
    "M5": "Motion, kinematics, dynamics",
    "C6": "Controller",
    "S7": "Simulation",
    "X8": "Projects, cell files, models, recordings",
    "X9": "Robots in files",
    "U9": "Use of the commands",
    "P1": "Knowledge bases",
}


def page(kind: Kind) -> str:
    """Return the page of one kind."""
    return (
        f"# {kind.code} {kind.slug}\n\n"
        f"*{kind.severity.value}* · {kind.summary}\n\n"
        f"{kind.explanation}\n\n"
        f"`ropsim explain {kind.code}` prints this page. [All diagnostics](README.md)\n"
    )


def index(kinds: Mapping[str, Kind]) -> str:
    """Return the list of all kinds, by band."""
    lines = ["# Diagnostics", "", "Made from the catalogue by `make docs`; a code is never used again."]
    for band, title in BANDS.items():
        lines += ["", f"## {band}xx {title}", "", "| code | found | severity |", "|---|---|---|"]
        lines += [
            f"| [{code}]({code}.md) | `{kind.slug}`: {kind.summary} | {kind.severity.value} |"
            for code, kind in kinds.items()
            if code.startswith(band)
        ]
    return "\n".join(lines) + "\n"


def pages() -> Mapping[Path, str]:
    """Return every page by path.

    Raises:
        ValueError: a code belongs to no band.
    """
    kinds = all_kinds()
    strays = [code for code in kinds if code[:2] not in BANDS]
    if strays:
        raise ValueError(f"codes outside of all bands: {', '.join(strays)}")
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
    for path in FOLDER.glob("*.md"):
        if path not in wanted:
            path.unlink()
    for path, text in wanted.items():
        path.write_text(text, "utf-8")
    print(f"{len(wanted)} pages written")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
