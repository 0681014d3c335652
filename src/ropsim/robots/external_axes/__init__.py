"""Mechanisms of stations in addition to their arms, one file each: carriers of the arm or the workpiece."""

from ropsim.robots.external_axes.gantry import gantry as gantry
from ropsim.robots.external_axes.linear_track import linear_track as linear_track
from ropsim.robots.external_axes.tilting_turntable import tilting_turntable as tilting_turntable
from ropsim.robots.external_axes.turntable import turntable as turntable
