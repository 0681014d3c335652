"""Result of calibrating a project."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from ropsim.core import SourceText, frozen_dataclass
from ropsim.model import JointType

if TYPE_CHECKING:
    from ropsim.calibration import Calibration


@frozen_dataclass
class CalibratedProject:
    """A calibration and the new cell file.

    Attributes:
        calibration: the calibration.
        section: of the cell file in which the controller stands, as a dotted name.
        values: of the keys in it that change, as written.
        axes: whether each axis turns or slides, n of them.
        cell_text: the cell file with them, otherwise unchanged; None if nothing changes, or if the form of
            the section does not allow adding them.
    """

    calibration: "Calibration"
    section: str
    values: Mapping[str, str]
    axes: tuple[JointType, ...]
    cell_text: SourceText | None
