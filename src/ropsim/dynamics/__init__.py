"""Rigid-body dynamics of serial arms with motors and friction, as generated code."""

from ropsim.dynamics.arm import bias as bias
from ropsim.dynamics.arm import forward_dynamics as forward_dynamics
from ropsim.dynamics.arm import friction as friction
from ropsim.dynamics.arm import gravity as gravity
from ropsim.dynamics.arm import inverse_dynamics as inverse_dynamics
from ropsim.dynamics.arm import mass_matrix as mass_matrix
from ropsim.dynamics.arm import rigid_inverse_dynamics as rigid_inverse_dynamics
from ropsim.dynamics.arm_functions import ArmFunctions as ArmFunctions
from ropsim.dynamics.arm_functions import compiled as compiled
from ropsim.dynamics.arm_functions import identifier as identifier
from ropsim.dynamics.arm_functions import trace_forward as trace_forward
from ropsim.dynamics.axis_inertia import axis_inertias as axis_inertias
from ropsim.dynamics.diagnostics import ChainTooLongError as ChainTooLongError
from ropsim.dynamics.diagnostics import ModelNumberError as ModelNumberError
from ropsim.dynamics.diagnostics import StateShapeError as StateShapeError
from ropsim.dynamics.drive_dc import direction as direction
from ropsim.dynamics.drive_dc import torque_constants as torque_constants
from ropsim.dynamics.drive_dc import torque_per_ampere as torque_per_ampere
from ropsim.dynamics.drive_dc import trace_current_rate as trace_current_rate
from ropsim.dynamics.inertia import last_body as last_body
from ropsim.dynamics.model_check import MOST_JOINTS as MOST_JOINTS
from ropsim.dynamics.model_check import check_model as check_model
from ropsim.dynamics.traced_arm import trace_arm as trace_arm
