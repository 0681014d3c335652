"""Safe pieces of HTML and SVG."""

import html
import re
from collections.abc import Iterable

from ropsim.views.words.characters import clean


def text(value: str) -> str:
    """Return user text for use in HTML content and attributes: escaped, the invisible made visible."""
    return html.escape(clean(value).encode("utf-8", "replace").decode("utf-8"), quote=True)


def prose(value: str) -> str:
    """Return user text for HTML content, with text between backticks as code."""
    return re.sub("`([^`]+)`", r"<code>\1</code>", text(value))


def coordinate(value: float) -> str:
    """Return an SVG coordinate with one decimal at most."""
    short = f"{value:.1f}"
    return short.removesuffix(".0")


def points(xs: Iterable[float], ys: Iterable[float]) -> str:
    """Return the `points` of a polyline."""
    return " ".join(f"{coordinate(x)},{coordinate(y)}" for x, y in zip(xs, ys, strict=True))


def table(
    caption: str, header: tuple[str, ...], rows: Iterable[tuple[str, ...]], kind: str = "numbers"
) -> str:
    """Return a table; header and cells are HTML already, the first cell of a row is its header.

    Args:
        caption: content of the table.
        header: titles of the columns.
        rows: as many cells each as there are titles.
        kind: class of the table; `words` sets all columns as running text.
    """
    head = "".join(f'<th scope="col">{title}</th>' for title in header)
    body = "".join(
        f'<tr><th scope="row">{row[0]}</th>' + "".join(f"<td>{cell}</td>" for cell in row[1:]) + "</tr>\n"
        for row in rows
    )
    return (
        f'<div class="scroll" tabindex="0"><table class="{kind}"><caption>{caption}</caption>\n'
        f"<thead><tr>{head}</tr></thead>\n"
        f"<tbody>\n{body}</tbody></table></div>\n"
    )
