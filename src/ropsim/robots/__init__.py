"""The built-in robots: names to models and to their controllers."""

from ropsim.robots.devices import belt as belt
from ropsim.robots.devices import slide as slide
from ropsim.robots.devices import turntable as turntable
from ropsim.robots.diagnostics import NoControllerError as NoControllerError
from ropsim.robots.diagnostics import UnknownRobotError as UnknownRobotError
from ropsim.robots.library import STANDARD_RATES as STANDARD_RATES
from ropsim.robots.library import default_controller as default_controller
from ropsim.robots.library import load as load
from ropsim.robots.library import names as names
from ropsim.robots.standard_controller import LoopBandwidths as LoopBandwidths
from ropsim.robots.standard_controller import standard_bandwidths as standard_bandwidths
from ropsim.robots.standard_controller import standard_gains as standard_gains
