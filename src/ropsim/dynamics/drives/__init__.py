"""Drives as chains of blocks: contributions of each block to the equations of an arm, as traced formulas."""

from ropsim.dynamics.drives.block import Carried as Carried
from ropsim.dynamics.drives.block import Column as Column
from ropsim.dynamics.drives.block import Limit as Limit
from ropsim.dynamics.drives.block import LimitSort as LimitSort
from ropsim.dynamics.drives.block import Rubbing as Rubbing
from ropsim.dynamics.drives.block import Steepness as Steepness
from ropsim.dynamics.drives.chain import DriveChain as DriveChain
from ropsim.dynamics.drives.chain import chain_of as chain_of
from ropsim.dynamics.drives.faults import drive_fault as drive_fault
from ropsim.dynamics.drives.faults import range_fault as range_fault
from ropsim.dynamics.drives.faults import shared_supply_fault as shared_supply_fault
from ropsim.dynamics.drives.hydraulics.servo_valve import flow_into as flow_into
from ropsim.dynamics.drives.hydraulics.servo_valve import least_opening as least_opening
from ropsim.dynamics.drives.hydraulics.supply import SUPPLY as SUPPLY
from ropsim.dynamics.drives.hydraulics.supply import SUPPLY_SIZE as SUPPLY_SIZE
from ropsim.dynamics.drives.hydraulics.supply import supply_groups as supply_groups
from ropsim.dynamics.drives.hydraulics.supply import supply_numbers as supply_numbers
from ropsim.dynamics.drives.hydraulics.supply import trace_supply as trace_supply
from ropsim.dynamics.drives.steady import SteadyDrive as SteadyDrive
from ropsim.dynamics.drives.steady import command_band as command_band
from ropsim.dynamics.drives.steady import command_limit as command_limit
from ropsim.dynamics.drives.steady import friction_steepness as friction_steepness
from ropsim.dynamics.drives.steady import largest_effort as largest_effort
from ropsim.dynamics.drives.steady import reflected_inertia as reflected_inertia
from ropsim.dynamics.drives.steady import steady_drive as steady_drive
