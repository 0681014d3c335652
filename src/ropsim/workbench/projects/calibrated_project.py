"""What calibrating a project gives."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from ropsim.core import SourceText, frozen_dataclass
from ropsim.model import JointType

if TYPE_CHECKING:
    from ropsim.calibration import Calibration


@frozen_dataclass
class CalibratedProject:
    """A calibration and what becomes of the cell file.

    Attributes:
        calibration: what was found.
        section: of the cell file in which the controller stands, as a dotted name.
        values: of the keys in it that change, as they are written.
        axes: whether each axis turns or slides, n of them.
        cell_text: the cell file with them, all else as it was; None where nothing changes, or where the
            section stands in the file in a way that they cannot be added to.
    """

    calibration: "Calibration"
    section: str
    values: Mapping[str, str]
    axes: tuple[JointType, ...]
    cell_text: SourceText | None
