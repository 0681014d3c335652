"""The built-in robots: names to models and to their controllers."""

from ropsim.robots.catalogue import INDEX as INDEX
from ropsim.robots.catalogue import CatalogueEntry as CatalogueEntry
from ropsim.robots.catalogue import catalogue as catalogue
from ropsim.robots.catalogue import catalogue_text as catalogue_text
from ropsim.robots.devices import conveyor as conveyor
from ropsim.robots.devices import rotary as rotary
from ropsim.robots.devices import shaped_conveyor as shaped_conveyor
from ropsim.robots.devices import slide as slide
from ropsim.robots.diagnostics import NoControllerError as NoControllerError
from ropsim.robots.diagnostics import UnknownRobotError as UnknownRobotError
from ropsim.robots.driven_axes import AxisData as AxisData
from ropsim.robots.driven_axes import driven_rotary as driven_rotary
from ropsim.robots.driven_axes import driven_slide as driven_slide
from ropsim.robots.external_axes import gantry as gantry
from ropsim.robots.external_axes import linear_track as linear_track
from ropsim.robots.external_axes import tilting_turntable as tilting_turntable
from ropsim.robots.external_axes import turntable as turntable
from ropsim.robots.library import STANDARD_RATES as STANDARD_RATES
from ropsim.robots.library import default_controller as default_controller
from ropsim.robots.library import load as load
from ropsim.robots.library import names as names
from ropsim.robots.standard_controller import LoopBandwidths as LoopBandwidths
from ropsim.robots.standard_controller import standard_bandwidths as standard_bandwidths
from ropsim.robots.standard_controller import standard_gains as standard_gains
from ropsim.robots.standard_controller import swings as swings
