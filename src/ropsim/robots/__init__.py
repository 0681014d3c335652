"""The built-in robots: names to models and to their controllers."""

from ropsim.robots.diagnostics import NoControllerError as NoControllerError
from ropsim.robots.diagnostics import UnknownRobotError as UnknownRobotError
from ropsim.robots.library import default_controller as default_controller
from ropsim.robots.library import load as load
from ropsim.robots.library import names as names
