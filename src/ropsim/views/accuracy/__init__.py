"""Figures by formulas of ISO 9283:1998 from commanded and attained poses: paths, repeats, corners, stops."""

from ropsim.views.accuracy.conditions import CYCLES as CYCLES
from ropsim.views.accuracy.conditions import AccuracyConditions as AccuracyConditions
from ropsim.views.accuracy.contours import ContourFigures as ContourFigures
from ropsim.views.accuracy.contours import ContourRows as ContourRows
from ropsim.views.accuracy.contours import contours as contours
from ropsim.views.accuracy.corners import CornerFigures as CornerFigures
from ropsim.views.accuracy.corners import corner_figures as corner_figures
from ropsim.views.accuracy.matching import largest_angle as largest_angle
from ropsim.views.accuracy.repeats import path_repeatability as path_repeatability
from ropsim.views.accuracy.speeds import SpeedFigures as SpeedFigures
from ropsim.views.accuracy.speeds import speed_figures as speed_figures
from ropsim.views.accuracy.stops import BAND as BAND
from ropsim.views.accuracy.stops import StopFigures as StopFigures
from ropsim.views.accuracy.stops import stop_figures as stop_figures
