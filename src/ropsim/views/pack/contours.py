"""Contours of a run in its pack: what is driven, and what is attained with its error enlarged."""

import numpy as np

from ropsim.flow import Recording
from ropsim.spatial import Array
from ropsim.views.accuracy import ContourFigures, ContourRows
from ropsim.views.accuracy.contour_drawing import contour_drawing
from ropsim.views.markup.decimate import along_curve
from ropsim.views.summary.station_summary import drawn_contours
from ropsim.views.summary.summary import Summary
from ropsim.views.words.contours import contour_name

POINTS = 300
"""Points of a curve at most."""
FINENESS = 1e-3
"""A curve is drawn as exact as this share of the size of its contour."""
_DIGITS = 6


def packed_contours(recording: Recording, summary: Summary) -> list[dict[str, object]]:
    """Return the contours of all stations with the largest errors, in order of stations and time."""
    return [
        _packed(one, rows) for station in summary.stations for one, rows in drawn_contours(recording, station)
    ]


def _packed(one: ContourFigures, rows: ContourRows) -> dict[str, object]:
    drawing = contour_drawing(one, rows)
    size = float(np.ptp(drawing.wanted, axis=0).max())
    return {
        "station": one.station,
        "name": contour_name(one),
        "start": one.start,
        "end": one.planned_end,
        "path_max": one.path_max,
        "path_mean": one.path_mean,
        "time": one.time,
        "tracking_max": one.tracking_max,
        "tracking_end": one.tracking_end,
        "overshoot": one.overshoot,
        "axes": list(drawing.axes),
        "factor": drawing.factor,
        "wanted": _points(drawing.wanted, FINENESS * size),
        "attained": _points(drawing.attained, FINENESS * size),
    }


def _points(curve: Array, tolerance: float) -> list[list[float]]:
    kept = along_curve(curve[:, 0], curve[:, 1], tolerance, POINTS, np.arange(0))
    found: list[list[float]] = np.round(curve[kept], _DIGITS).tolist()
    return found
