"""Robots that were read are kept until their text or a file that they used changes."""

from collections import OrderedDict
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TypeAlias

from ropsim.core import SourceText, frozen_dataclass
from ropsim.model import ReadRobot
from ropsim.workbench.robots.read_request import ReadRequest

MOST = 16
"""Readings that are kept."""

_Stamp: TypeAlias = tuple[int, int] | None
_Read: TypeAlias = Callable[[SourceText, ReadRequest], ReadRobot]


@frozen_dataclass
class _Kept:
    """A reading, and the files that it used with time of change and size; None for one that was missing."""

    read: ReadRobot
    files: Mapping[Path, _Stamp]


class KeptReadings:
    """Readings of robot files by their texts and requests."""

    def __init__(self) -> None:
        self._kept: OrderedDict[tuple[SourceText, ReadRequest], _Kept] = OrderedDict()

    def of(self, text: SourceText, request: ReadRequest, read: _Read) -> ReadRobot:
        """Return the reading of a text: a kept one if nothing has changed since.

        Args:
            text: of the file.
            request: how it is read.
            read: reads it.
        """
        key = text, request
        kept = self._kept.get(key)
        if kept is None or any(_stamp(path) != stamp for path, stamp in kept.files.items()):
            made = read(text, request)
            kept = _Kept(made, {path: _stamp(path) for path in made.files})
            self._kept[key] = kept
            if len(self._kept) > MOST:
                self._kept.popitem(last=False)
        self._kept.move_to_end(key)
        return kept.read


def _stamp(path: Path) -> _Stamp:
    try:
        facts = path.stat()
    except (OSError, ValueError):
        return None
    return facts.st_mtime_ns, facts.st_size
