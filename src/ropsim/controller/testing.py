"""Door for tests: names behind the front of the package. Production code does not import it."""

from ropsim.controller.correction_room import SHARE as SHARE
from ropsim.controller.diagrams.diagram_law import BLOCK_CODE as BLOCK_CODE
from ropsim.controller.motion_clock_kernel import ClockNumbers as ClockNumbers
from ropsim.controller.motion_clock_kernel import advance_clock as advance_clock
