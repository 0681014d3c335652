"""The report of a recording: terminal text, HTML page with the built viewer, summary."""

import base64
import json
from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import partial
from importlib.resources import files
from pathlib import Path

from ropsim.cellfile import mesh_in_files
from ropsim.core import Diagnostic, SourceText, frozen_dataclass, replace_file
from ropsim.flow import Recording
from ropsim.meshes import MeshLibrary, load_meshes
from ropsim.model import Cell, body_tree
from ropsim.records import numeric, pack_bytes
from ropsim.views import (
    Comparison,
    NoReplay,
    Replay,
    Style,
    Summary,
    comparison_text,
    html_report,
    scene,
    summarize,
    terminal_report,
)


@frozen_dataclass
class Viewer:
    """The viewer.

    Attributes:
        script: its program.
        style: its style sheet.
    """

    script: str
    style: str


def built_viewer() -> Viewer | None:
    """Return the viewer, None where ropsim was installed without its built pages."""
    folder = files("ropsim").joinpath("static", "replay")
    try:
        script = folder.joinpath("replay.js").read_text("utf-8")
        style = folder.joinpath("replay.css").read_text("utf-8")
    except FileNotFoundError:
        return None
    return Viewer(script, style)


OTHER_ARM = "No 3-D replay: the recording is not of the arm of this cell."
NOT_BUILT = "No 3-D replay: this ropsim has been installed without its built pages."


@frozen_dataclass
class Setting:
    """Where a run took place.

    Attributes:
        cell: that was simulated.
        folder: of the project, in which the meshes of the cell are.
        texts: `cell.toml` and files of robots, for the places of findings.
        meshes: as read; None before reading.
    """

    cell: Cell
    folder: Path
    texts: tuple[SourceText, ...] = ()
    meshes: MeshLibrary | None = None


@frozen_dataclass
class Report:
    """A report; everything in it is derived from the recording and the cell.

    Attributes:
        recording: of the run.
        summary: its key figures.
        sources: program texts for quoting, by the names that spans use.
        setting: where the run took place, for the replay; None where that is not known.
        before: findings of reading and compiling, and of meshes that cannot be drawn.
        comparison: with runs in which something is changed; None for none.
    """

    recording: Recording
    summary: Summary
    sources: Mapping[str, SourceText]
    setting: Setting | None = None
    before: tuple[Diagnostic, ...] = ()
    comparison: Comparison | None = None

    @classmethod
    def of(
        cls,
        recording: Recording,
        sources: Mapping[str, SourceText],
        setting: Setting | None = None,
        before: Iterable[Diagnostic] = (),
    ) -> "Report":
        """Return the report of a recording; it is summarized once."""
        found = tuple(before)
        return cls(recording, summarize(recording, found), sources, setting, found)

    def text(self, style: Style = Style.PLAIN) -> str:
        """Return the report for a terminal."""
        report = terminal_report(self.summary, style)
        compared = comparison_text(self.comparison, style) if self.comparison else ""
        return f"{report}\n{compared}" if compared else report

    def drawn(self) -> "Report":
        """Return the report with the meshes of its cell; its findings name meshes that cannot be drawn."""
        if self.setting is None or self.setting.meshes is not None:
            return self
        meshes = load_meshes(
            self.setting.folder, self.setting.cell, partial(mesh_in_files, self.setting.texts)
        )
        setting, before = replace(self.setting, meshes=meshes), (*self.before, *meshes.diagnostics)
        drawn = Report.of(self.recording, self.sources, setting, before)
        return replace(drawn, comparison=self.comparison)

    def html(self) -> str:
        """Return the self-contained HTML page, with the 3-D replay where the cell is known."""
        drawn = self.drawn()
        return html_report(drawn.recording, drawn.summary, drawn.sources, drawn._replay(), drawn.comparison)

    def save(self, path: str | Path) -> None:
        """Write the HTML page; an older file is replaced in one step.

        Raises:
            OSError: the place cannot be written.
        """
        replace_file(Path(path), self.html().encode())

    def _is_of(self, cell: Cell) -> bool:
        """Return whether the recording has joint coordinates of every mechanism of a cell."""
        for name, mechanism in body_tree(cell).mechanisms.items():
            q = self.recording.channels.get(self.recording.facts.channel("q", name))
            if q is None or q.values.shape[1:] != (mechanism.n,):
                return False
        return True

    def _replay(self) -> Replay | NoReplay | None:
        if self.setting is None or self.setting.meshes is None:
            return None
        cell, meshes = self.setting.cell, self.setting.meshes
        if not self._is_of(cell):
            return NoReplay(OTHER_ARM)
        viewer = built_viewer()
        if viewer is None:
            return NoReplay(NOT_BUILT)
        return Replay(
            viewer.script,
            viewer.style,
            _json(scene(cell, meshes.addresses)),
            _base64(pack_bytes(cell, self.recording, self.summary, self.before)),
            _json({name: source.text for name, source in self.sources.items()}),
            {address: _base64(content) for address, content in meshes.contents.items()},
        )


def _json(value: object) -> str:
    return json.dumps(numeric(value), allow_nan=False, separators=(",", ":"))


def _base64(content: bytes) -> str:
    return base64.b64encode(content).decode("ascii")
