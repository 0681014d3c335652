"""The names of the points in the tables `points/*.csv` of a project, which no new point may have."""

import asyncio
import csv
import io
from collections.abc import Iterator
from pathlib import Path

from ropsim.core import LeadsOutError
from ropsim.studio.texts.project_files import Stamp, content, files_in, stamp

FOLDER, ENDING = "points", ".csv"
HEADS = 2
"""Lines above the points: names of columns, and their units."""
MOST_NAMES = 10_000


class PointTables:
    """The tables of points of a project.

    Attributes:
        names: of all points, in order; as the tables have had them at the last look.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._stamps: dict[str, Stamp] = {}
        self.names: tuple[str, ...] = ()

    async def look(self) -> bool:
        """Read tables that have changed; return whether the names are others.

        Raises:
            OSError: the system cannot list the files.
        """
        before = self.names
        await asyncio.to_thread(self._look)
        return self.names != before

    def _look(self) -> None:
        found = ((name, stamp(self._folder / name)) for name in files_in(self._folder, FOLDER, (ENDING,)))
        stamps = {name: one for name, one in found if one is not None}
        if stamps == self._stamps:
            return
        names = {point for table in stamps for point in self._points(table)}
        self._stamps, self.names = stamps, tuple(sorted(names)[:MOST_NAMES])

    def _points(self, table: str) -> Iterator[str]:
        """Yield the names in a table, none where it cannot be read: that is said where it is used."""
        try:
            text = (content(self._folder, table) or b"").decode("utf-8-sig", "replace")
            rows = list(csv.reader(io.StringIO(text)))
        except (csv.Error, LeadsOutError, OSError):
            return
        yield from (name for row in rows[HEADS:] if row and (name := row[0].strip()))
