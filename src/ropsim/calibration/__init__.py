"""Calibration: limits and look-ahead of a controller from the trace of a robot that ran a program."""

from ropsim.calibration.calibrate import calibrate as calibrate
from ropsim.calibration.calibration import Calibration as Calibration
from ropsim.calibration.calibration import SequenceTimes as SequenceTimes
from ropsim.calibration.calibration import TraceTime as TraceTime
from ropsim.calibration.diagnostics import CalibrationError as CalibrationError
from ropsim.calibration.knowledge import Knowledge as Knowledge
from ropsim.calibration.limits import MotionSettings as MotionSettings
from ropsim.calibration.limits import settings_of as settings_of
from ropsim.calibration.trace.trace import Trace as Trace
from ropsim.calibration.trace.trace_reader import LARGEST as LARGEST
from ropsim.calibration.trace.trace_reader import read_trace as read_trace
