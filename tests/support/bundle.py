"""What the built pages consist of: scripts that a browser loads at once, scripts that come later."""

import gzip
import re
from collections.abc import Iterable
from pathlib import Path

import ropsim

STATIC = Path(ropsim.__file__).parent / "static"


def compressed(paths: Iterable[Path]) -> int:
    """Return the total size of files as sent with gzip."""
    return sum(len(gzip.compress(path.read_bytes(), 9)) for path in paths)


def scripts_at_once() -> set[Path]:
    """Return the scripts that index.html names: the entry and what it imports statically."""
    return _at_once("js")


def styles_at_once() -> set[Path]:
    """Return the style sheets that index.html names; those of panels that open later come with these."""
    return _at_once("css")


def scripts_of_the_editor() -> set[Path]:
    """Return the scripts that hold CodeMirror, known by one of its class names."""
    scripts = (STATIC / "studio").rglob("*.js")
    return {path for path in scripts if "cm-widgetBuffer" in path.read_text("utf-8")}


def of_the_replay() -> list[Path]:
    """Return script and style of the replay."""
    return [STATIC / "replay" / name for name in ("replay.js", "replay.css")]


def _at_once(ending: str) -> set[Path]:
    index = (STATIC / "studio" / "index.html").read_text("utf-8")
    return {STATIC / "studio" / name for name in re.findall(rf'"/(assets/[^"]+\.{ending})"', index)}
