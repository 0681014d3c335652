"""Write the tables of docs/reference/parts.md and the pictures that it shows, from the catalogue of parts.

python -m tools.part_page           write them
python -m tools.part_page --check   compare only; exit 1 and name what is stale

A picture says in its `Source` of what it was drawn; only those are drawn anew of which that has changed.
"""

import sys
from pathlib import Path

from ropsim.parts import (
    PART_KINDS,
    TCP,
    PartKind,
    bound_words,
    fact_words,
    library_part,
    range_words,
    value_words,
    values_words,
)
from ropsim.views import PictureOptions, part_png, part_print, png_words

ROOT = Path(__file__).parent.parent
PAGE = ROOT / "docs" / "reference" / "parts.md"
PICTURES = ROOT / "docs" / "images" / "parts"
SEEN = PictureOptions(width=320, elevation=12.0)
_WIDTH = 150  # of a picture on the page


def overview() -> str:
    """Return the table of all kinds."""
    lines = ["| | kind | part | for | frame |", "|---|---|---|---|---|"]
    for kind in PART_KINDS.values():
        picture = f'<img src="../images/parts/{kind.name}.png" width="{_WIDTH}" alt="{kind.title}">'
        link = f"[`{kind.name}`](#{kind.name})"
        lines.append(f"| {picture} | {link} | {kind.title} | {kind.use.value} | {kind.frame} |")
    return "\n".join(lines) + "\n"


def section(kind: PartKind) -> str:
    """Return the tables of parameters and products of a kind."""
    lines = [
        f"## `{kind.name}`\n",
        f"{kind.title}. Frame: {kind.frame[0].lower()}{kind.frame[1:]}\n",
        "| parameter | default | range | origin | meaning |",
        "|---|---|---|---|---|",
    ]
    for one in kind.parameters:
        source = f": {one.source}" if one.source else ""
        cells = (f"`{one.name}`", value_words(one, one.default), range_words(one))
        lines.append(f"| {' | '.join(cells)} | {one.origin.value}{source} | {one.meaning} |")
    if kind.at_most:
        lines += ["", f"{', '.join(bound_words(bound) for bound in kind.at_most)}."]
    if kind.products:
        lines += ["", "| model | product | figures | origin | estimated |", "|---|---|---|---|---|"]
    for product in kind.products:
        facts = "; ".join(fact_words(fact) for fact in product.facts)
        figures = "; ".join(text for text in (values_words(kind, product.values), facts) if text)
        estimates = values_words(kind, product.estimates)
        X_MT = library_part(kind.name, product.name).X_MT
        if X_MT is not None and TCP not in product.values:
            words = f"TCP {1e3 * X_MT.position[2]:.4g} mm"
            estimates = f"{estimates}, {words}" if estimates else words
        origin = f"{product.origin.value}: {product.source}"
        lines.append(f"| `{product.name}` | {product.title} | {figures} | {origin} | {estimates or '–'} |")
    return "\n".join(lines) + "\n"


def page(text: str) -> str:
    """Return the page with tables as they have to be."""
    sections = "\n".join(section(kind) for kind in PART_KINDS.values())
    for mark, table in (("kinds", overview()), ("parameters", sections)):
        begin, end = f"<!-- {mark}: written by tools/part_page.py -->\n", f"<!-- end of {mark} -->\n"
        before, _, rest = text.partition(begin)
        _, _, after = rest.partition(end)
        text = f"{before}{begin}\n{table}\n{end}{after}"
    return text


def stale_pictures() -> list[str]:
    """Return the names of kinds whose picture is not there, or of another state of the part."""
    found = []
    for name in PART_KINDS:
        path = PICTURES / f"{name}.png"
        drawn = png_words(path.read_bytes()).get("Source") if path.exists() else None
        if drawn != part_print(library_part(name), SEEN):
            found.append(name)
    return found


def main(arguments: list[str]) -> int:
    """Write or check page and pictures; return the exit code."""
    text = PAGE.read_text("utf-8")
    wanted, stale = page(text), stale_pictures()
    gone = sorted(path for path in PICTURES.glob("*.png") if path.stem not in PART_KINDS)
    if arguments == ["--check"]:
        names = [PAGE.name] * (wanted != text) + [f"{name}.png" for name in stale]
        names += [path.name for path in gone]
        if names:
            print(f"stale: {', '.join(names)}; run python -m tools.part_page")
        return int(bool(names))
    PAGE.write_text(wanted, "utf-8")
    PICTURES.mkdir(parents=True, exist_ok=True)
    for path in gone:
        path.unlink()
    for name in stale:
        (PICTURES / f"{name}.png").write_bytes(part_png(name, library_part(name), SEEN))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
