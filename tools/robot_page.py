"""Write the tables of docs/reference/robots.md and the pictures that it shows, from the models.

python -m tools.robot_page           write them
python -m tools.robot_page --check   compare only; exit 1 and name what is stale

A picture says in its `Source` of what it was drawn; only those are drawn anew of which that has changed.
"""

import sys
from collections.abc import Sequence
from math import isfinite
from pathlib import Path

from tools.library_index import KINDS

from ropsim.robots import CatalogueEntry, catalogue, load
from ropsim.views import PictureOptions, picture_print, png_words, robot_png

ROOT = Path(__file__).parent.parent
PAGE = ROOT / "docs" / "reference" / "robots.md"
PICTURES = ROOT / "docs" / "images" / "robots"
SEEN = PictureOptions(width=320)
_WIDTH = 130  # of a picture on the page
_LINK = "../images/robots"


def table(entries: list[CatalogueEntry]) -> str:
    """Return a table of robots with their pictures."""
    lines = [
        "| | name | robot | axes | reach mm | payload kg | inverse kinematics | data | source of the axes |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    for one in entries:
        picture = f'<img src="{_LINK}/{one.name}.png" width="{_WIDTH}" alt="{one.title}">'
        payload = f"{one.rated_payload:g}" if isfinite(one.rated_payload) else "–"
        cells = (
            *(picture, f"`{one.name}`", one.title, str(one.axes), f"{1e3 * one.reach:.0f}", payload),
            *(one.solver, by_kind(one.data), one.source),
        )
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"


def by_kind(data: Sequence[str]) -> str:
    """Return groups of numbers by their kinds, as `published: axes, limits; estimated: friction`."""
    kinds: dict[str, list[str]] = {kind: [] for kind in KINDS}
    for one in data:
        group, _, words = one.partition(" ")
        for kind in words.split(" and ") if words else ["published"]:
            kinds[kind].append(group)
    return "; ".join(f"{kind}: {', '.join(groups)}" for kind, groups in kinds.items() if groups)


def page(text: str) -> str:
    """Return the page with tables as they have to be."""
    makers = sorted(
        (one for one in catalogue() if one.maker), key=lambda one: (one.maker, one.axes, one.model)
    )
    others = [one for one in catalogue() if not one.maker]
    for mark, entries in (("makers", makers), ("others", others)):
        begin, end = f"<!-- {mark}: written by tools/robot_page.py -->\n", f"<!-- end of {mark} -->\n"
        before, _, rest = text.partition(begin)
        _, _, after = rest.partition(end)
        text = f"{before}{begin}\n{table(entries)}\n{end}{after}"
    return text


def stale_pictures() -> list[str]:
    """Return the names of robots whose picture is not there, or of another state of the model."""
    found = []
    for one in catalogue():
        path = PICTURES / f"{one.name}.png"
        drawn = png_words(path.read_bytes()).get("Source") if path.exists() else None
        if drawn != picture_print(load(one.name), SEEN):
            found.append(one.name)
    return found


def main(arguments: list[str]) -> int:
    """Write or check page and pictures; return the exit code."""
    text = PAGE.read_text("utf-8")
    wanted, stale = page(text), stale_pictures()
    names = {one.name for one in catalogue()}
    gone = sorted(path for path in PICTURES.glob("*.png") if path.stem not in names)
    if arguments == ["--check"]:
        told = (
            [PAGE.name] * (wanted != text) + [f"{name}.png" for name in stale] + [path.name for path in gone]
        )
        if told:
            print(f"stale: {', '.join(told)}; run python -m tools.robot_page")
        return int(bool(told))
    PAGE.write_text(wanted, "utf-8")
    PICTURES.mkdir(parents=True, exist_ok=True)
    for path in gone:
        path.unlink()
    for name in stale:
        (PICTURES / f"{name}.png").write_bytes(robot_png(load(name), SEEN))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
