"""How far and how quickly a controller lets a sensor shift a path."""

from ropsim.core import frozen_dataclass


@frozen_dataclass
class CorrectionLimits:
    """Limits of a path correction; estimated, as manuals keep theirs in settings of the cell.

    Attributes:
        size: greatest shift to either side [m].
        speed: greatest speed of the shift [m/s].
        acceleration: greatest acceleration of it [m/s²].
    """

    size: float = 0.02
    speed: float = 0.02
    acceleration: float = 0.5
