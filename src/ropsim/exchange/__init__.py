"""Robots in other formats: URDF, xacro, MJCF, SDFormat, AP242; every conversion reports its losses."""

from ropsim.exchange.files.folder import ReadOptions as ReadOptions
from ropsim.exchange.files.folder import RobotFolder as RobotFolder
from ropsim.exchange.files.packages import Packages as Packages
from ropsim.exchange.files.surroundings import around_file as around_file
from ropsim.exchange.files.surroundings import in_project as in_project
from ropsim.exchange.losses.diagnostics import DOUBTFUL_BODY as DOUBTFUL_BODY
from ropsim.exchange.losses.diagnostics import LIMIT_UNKNOWN as LIMIT_UNKNOWN
from ropsim.exchange.losses.loss_diagnostics import losses_refused as losses_refused
from ropsim.exchange.nirox_door import kept_lost as kept_lost
from ropsim.exchange.nirox_door import read_nirox as read_nirox
from ropsim.exchange.nirox_door import write_nirox as write_nirox
from ropsim.exchange.read_mjcf import read_mjcf as read_mjcf
from ropsim.exchange.read_urdf import read_urdf as read_urdf
from ropsim.exchange.write_ap242 import write_ap242 as write_ap242
from ropsim.exchange.write_mjcf import write_mjcf as write_mjcf
from ropsim.exchange.write_sdf import write_sdf as write_sdf
from ropsim.exchange.write_urdf import write_urdf as write_urdf
