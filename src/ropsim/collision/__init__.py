"""Distances and collisions between the bodies of a cell, exact for convex solids; no time, no motion."""

from ropsim.collision.collisions import AS_AT_START as AS_AT_START
from ropsim.collision.collisions import TOUCH as TOUCH
from ropsim.collision.collisions import Collisions as Collisions
from ropsim.collision.collisions import Coordinates as Coordinates
from ropsim.collision.convex import Convex as Convex
from ropsim.collision.depth import COARSE as COARSE
from ropsim.collision.distance import distance as distance
from ropsim.collision.distance import in_collision as in_collision
from ropsim.collision.pairs import Elsewhere as Elsewhere
from ropsim.collision.pairs import LeftOut as LeftOut
from ropsim.collision.pairs import Pair as Pair
from ropsim.collision.pairs import left_out as left_out
from ropsim.collision.pairs import owners as owners
from ropsim.collision.quick_hull import bounded_hull as bounded_hull
from ropsim.collision.separation import Nearness as Nearness
from ropsim.collision.separation import Separation as Separation
from ropsim.collision.solid_bodies import SolidBodies as SolidBodies
from ropsim.collision.solids import NO_MESHES as NO_MESHES
from ropsim.collision.solids import MeshPoints as MeshPoints
from ropsim.collision.solids import convexes as convexes
from ropsim.collision.solids import has_filled_hollow as has_filled_hollow
from ropsim.collision.ways import Approach as Approach
from ropsim.collision.ways import Carriers as Carriers
from ropsim.collision.ways import carried as carried
from ropsim.collision.ways import certified as certified
