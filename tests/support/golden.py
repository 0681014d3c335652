"""Golden files: the expected text stands in a file beside the tests."""

import os
from pathlib import Path

GOLDEN = Path(__file__).parent.parent / "golden"


def check_golden(path: Path, text: str) -> None:
    """Compare `text` with the golden file; `ROPSIM_UPDATE_GOLDEN=1` writes the file instead."""
    if os.environ.get("ROPSIM_UPDATE_GOLDEN") == "1":
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8", newline="\n")
    assert path.exists(), f"{path} is missing: run with ROPSIM_UPDATE_GOLDEN=1 and look at it"
    assert text == path.read_text(encoding="utf-8")
