"""The records that travel between modules: instructions, setpoints, recordings."""

from ropsim.flow.instructions import GripAction as GripAction
from ropsim.flow.instructions import GripInstruction as GripInstruction
from ropsim.flow.instructions import Instruction as Instruction
from ropsim.flow.instructions import MessageInstruction as MessageInstruction
from ropsim.flow.instructions import MotionKind as MotionKind
from ropsim.flow.instructions import MoveInstruction as MoveInstruction
from ropsim.flow.instructions import Origin as Origin
from ropsim.flow.instructions import OutputInstruction as OutputInstruction
from ropsim.flow.instructions import SyncInstruction as SyncInstruction
from ropsim.flow.instructions import WaitInstruction as WaitInstruction
from ropsim.flow.modal import ModalState as ModalState
from ropsim.flow.placement import Placement as Placement
from ropsim.flow.recording import Channel as Channel
from ropsim.flow.recording import Event as Event
from ropsim.flow.recording import Recording as Recording
from ropsim.flow.reference import JointReference as JointReference
from ropsim.flow.reference import JointSamples as JointSamples
from ropsim.flow.reference import PoseSetpoints as PoseSetpoints
from ropsim.flow.settling import SLOW as SLOW
from ropsim.flow.settling import Settling as Settling
from ropsim.flow.settling import settle_time as settle_time
from ropsim.flow.settling import settling_of as settling_of
