"""Workspaces of arms: what a point reaches, in which directions, and where to put the base."""

from ropsim.workspace.diagnostics import WorkspaceError as WorkspaceError
from ropsim.workspace.nearness import distances as distances
from ropsim.workspace.point import MovedPoint as MovedPoint
from ropsim.workspace.point import PointKind as PointKind
from ropsim.workspace.point import moved_point as moved_point
from ropsim.workspace.reachable import Reachable as Reachable
from ropsim.workspace.reachable import Resolution as Resolution
from ropsim.workspace.reachable import reachable as reachable
