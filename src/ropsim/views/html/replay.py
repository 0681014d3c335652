"""The 3-D replay inside a report: data and viewer as parts of the one page."""

import re
from collections.abc import Mapping
from dataclasses import field

from ropsim.core import frozen_dataclass
from ropsim.views.markup.markup import text

NO_SCRIPT = "The replay needs a browser that runs the script of this page; the report below does not."


@frozen_dataclass
class Replay:
    """Data of the viewer, as texts that fit into a page.

    Attributes:
        script: program of the viewer.
        style: its style sheet.
        scene: the scene description as JSON.
        pack: the pack of the run as base64.
        texts: texts of the project by name, as one JSON object.
        meshes: GLB files as base64, by address.
    """

    script: str
    style: str
    scene: str
    pack: str
    texts: str
    meshes: Mapping[str, str] = field(default_factory=dict)


@frozen_dataclass
class NoReplay:
    """Why a report has no replay.

    Attributes:
        reason: a sentence for people.
    """

    reason: str


def replay_section(replay: Replay | NoReplay | None) -> str:
    """Return the section of the page, or the line that says why there is none."""
    if replay is None:
        return ""
    if isinstance(replay, NoReplay):
        return f'<p class="quiet screen">{text(replay.reason)}</p>\n'
    return (
        '<section id="replay" class="replay" aria-labelledby="replay-title">\n'
        '<h2 id="replay-title">Replay</h2>\n'
        f"<noscript><p>{NO_SCRIPT}</p></noscript></section>\n"
    )


def replay_data(replay: Replay) -> str:
    """Return the elements that hold the data; none of them is a script that runs."""
    meshes = "".join(
        _data(f"replay-mesh-{address}", "text/plain", content) for address, content in replay.meshes.items()
    )
    return (
        _data("replay-scene", "application/json", _json(replay.scene))
        + _data("replay-texts", "application/json", _json(replay.texts))
        + _data("replay-pack", "text/plain", replay.pack)
        + meshes
    )


def inline_script(script: str) -> str:
    """Return a script in a form that an HTML page can hold between its script tags.

    `</script` would end the element, and `<!--` could hide its end. In a script both stand in texts and
    patterns only, where the escapes mean the same: a bare `<!--` would already be a comment.
    """
    return re.sub(r"<(/script|!--)", _escaped, script, flags=re.IGNORECASE)


def inline_style(style: str) -> str:
    """Return a style sheet in a form that an HTML page can hold between its style tags."""
    return re.sub(r"</(style)", r"<\\/\1", style, flags=re.IGNORECASE)


def _escaped(found: re.Match[str]) -> str:
    return f"\\x3c{found[1]}"


def _json(content: str) -> str:
    """Return JSON in which nothing looks like a tag; `<` stands in its texts only."""
    return content.replace("<", "\\u003c")


def _data(ident: str, kind: str, content: str) -> str:
    return f'<script type="{kind}" id="{ident}">{content}</script>\n'
