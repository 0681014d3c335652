"""Collisions of a run: every body against all else on all its ways, found in the recording."""

from ropsim.simulation.ways.run_collisions import Clearance as Clearance
from ropsim.simulation.ways.run_collisions import RunCollisions as RunCollisions
from ropsim.simulation.ways.run_collisions import run_collisions as run_collisions
