"""Files: no path of one machine, no registry host, exact versions."""

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
