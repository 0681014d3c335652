"""Kinematics of serial arms: poses, Jacobians, all branches of the inverse, postures; no time, no forces."""

from ropsim.kinematics.diagnostics import ArrayShapeError as ArrayShapeError
from ropsim.kinematics.diagnostics import NoClosedFormError as NoClosedFormError
from ropsim.kinematics.diagnostics import NotFiniteError as NotFiniteError
from ropsim.kinematics.forward import forward as forward
from ropsim.kinematics.forward import forward_batch as forward_batch
from ropsim.kinematics.forward import frames_batch as frames_batch
from ropsim.kinematics.forward import joint_frames as joint_frames
from ropsim.kinematics.inverse import branch as branch
from ropsim.kinematics.inverse import inverse as inverse
from ropsim.kinematics.inverse import inverse_batch as inverse_batch
from ropsim.kinematics.jacobian import jacobian as jacobian
from ropsim.kinematics.jacobian import jacobian_at as jacobian_at
from ropsim.kinematics.posture import POSTURES as POSTURES
from ropsim.kinematics.posture import Elbow as Elbow
from ropsim.kinematics.posture import Posture as Posture
from ropsim.kinematics.posture import Shoulder as Shoulder
from ropsim.kinematics.posture import Wrist as Wrist
from ropsim.kinematics.posture import posture as posture
from ropsim.kinematics.result import IkOptions as IkOptions
from ropsim.kinematics.result import IkResult as IkResult
from ropsim.kinematics.result import IkStatus as IkStatus
from ropsim.kinematics.result import Limits as Limits
from ropsim.kinematics.result import LimitViolation as LimitViolation
from ropsim.kinematics.result import Reach as Reach
from ropsim.kinematics.wrist import has_closed_form as has_closed_form
