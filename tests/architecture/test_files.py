"""Files: no path of one machine, no registry host, exact versions."""

import ast
import itertools
import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).parents[2]
FOREIGN = re.compile(
    r"registry\.npm"
    + r"js|pypi\.o"
    + r"rg|python"
    + r"hosted|deb\.deb"
    + r"ian|/(?:work|root|home|Users|opt)/[\w.-]+"
)
BINARY = {".png", ".npz", ".ico", ".jpg"}


def project_files() -> list[Path]:
    """Return what git tracks or would track; without git, the folders of the project."""
    listing = subprocess.run(
        ["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=ROOT, capture_output=True, check=False
    )
    if listing.returncode == 0:
        names = listing.stdout.decode().split("\0")
        return [ROOT / name for name in names if name and (ROOT / name).is_file()]
    folders = ("src", "tests", "docs", "examples", "tools", "benchmarks")
    files = [path for folder in folders for path in (ROOT / folder).rglob("*") if path.is_file()]
    return [path for path in files if "__pycache__" not in path.parts and "out" not in path.parts]


def test_no_file_names_a_place_of_one_machine_or_a_registry() -> None:
    found = [
        f"{path.relative_to(ROOT)}: {match[0]}"
        for path in project_files()
        if path.suffix not in BINARY and (match := FOREIGN.search(path.read_text("utf-8", errors="replace")))
    ]
    assert found == []


def test_every_pinned_version_is_exact() -> None:
    lines = (ROOT / "constraints.txt").read_text("utf-8").splitlines()
    pins = [line for line in lines if line and not line.startswith("#")]
    assert [pin for pin in pins if not re.fullmatch(r"[A-Za-z0-9_.-]+==[\w.]+", pin)] == []
    assert any(pin.startswith("numpy==") for pin in pins)


WIDE: set[str] = set()
LONG: set[str] = set()
SMALL_FILES = 120
PACKAGES = ROOT / "src" / "ropsim"
DATA = {"robots/arms"}


def modules() -> list[Path]:
    """Return the Python files of the packages, by their paths below `src/ropsim`."""
    return [path.relative_to(PACKAGES) for path in PACKAGES.rglob("*.py") if "static" not in path.parts]


def line_count(module: Path) -> int:
    return len((PACKAGES / module).read_text("utf-8").splitlines())


def test_a_folder_has_at_most_twenty_entries() -> None:
    inside = [path.relative_to(PACKAGES) for path in project_files() if path.is_relative_to(PACKAGES)]
    entries: dict[str, set[str]] = {}
    for path in inside:
        for folder, entry in itertools.pairwise([*reversed(path.parents), path]):
            entries.setdefault(folder.as_posix(), set()).add(entry.name)
    wide = {folder for folder, names in entries.items() if len(names) > 20}
    assert wide - DATA - {"."} == WIDE


def test_a_file_has_at_most_four_hundred_lines_and_few_have_less_than_forty() -> None:
    lengths = {path.as_posix(): line_count(path) for path in modules() if path.name != "__init__.py"}
    assert {name.rpartition("/")[2] for name, length in lengths.items() if length > 400} == LONG
    assert sum(length < 40 for length in lengths.values()) <= SMALL_FILES


def test_a_room_says_in_one_sentence_what_is_in_it() -> None:
    rooms = [path for path in modules() if path.name == "__init__.py" and len(path.parts) > 1]
    assert [
        room.as_posix()
        for room in rooms
        if not ast.get_docstring(ast.parse((PACKAGES / room).read_text("utf-8")))
    ] == []


MOST_BYTES = {"CHANGELOG.md": 15_000, "ARCHITECTURE.md": 12_000}
DIARIES = ("performance", "studio-performance", "robustness")
"""Pages of figures: they have room for the latest ones only."""


def page_limits() -> dict[Path, int]:
    """Return the most bytes of each page that would grow with every change."""
    pages = {ROOT / name: most for name, most in MOST_BYTES.items()}
    pages |= {ROOT / "docs" / "explanation" / f"{name}.md": 8_000 for name in DIARIES}
    return pages | {path: 3_000 for path in PACKAGES.rglob("README.md")}


def test_pages_that_grow_with_every_change_stay_short() -> None:
    long = {page for page, most in page_limits().items() if page.stat().st_size > most}
    assert {page.relative_to(ROOT).as_posix() for page in long} == set()


def test_a_row_of_the_code_map_is_one_line() -> None:
    rows = [
        line for line in (ROOT / "ARCHITECTURE.md").read_text("utf-8").splitlines() if line.startswith("|")
    ]
    assert len(rows) > 25
    assert [row for row in rows if len(row) > 120] == []
