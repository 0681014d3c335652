"""Simulation of servo-driven arms and of whole cells."""

from ropsim.flow import Fidelity as Fidelity
from ropsim.flow import InputChange as InputChange
from ropsim.simulation.adapting import Adaptation as Adaptation
from ropsim.simulation.kept_plans import KeptPlans as KeptPlans
from ropsim.simulation.kept_plans import Planning as Planning
from ropsim.simulation.kept_plans import planned_anew as planned_anew
from ropsim.simulation.live_sample import live_sample as live_sample
from ropsim.simulation.move_span import MoveSpan as MoveSpan
from ropsim.simulation.run import run as run
from ropsim.simulation.run_options import RunOptions as RunOptions
from ropsim.simulation.servo.diagnostics import DivergedError as DivergedError
from ropsim.simulation.servo.diagnostics import DriveDataError as DriveDataError
from ropsim.simulation.servo.diagnostics import NoDrivesError as NoDrivesError
from ropsim.simulation.servo.diagnostics import OptionError as OptionError
from ropsim.simulation.servo.diagnostics import ServoArrayError as ServoArrayError
from ropsim.simulation.servo.recorder import Recorder as Recorder
from ropsim.simulation.servo.servo import Servo as Servo
from ropsim.simulation.servo.state import ServoState as ServoState
from ropsim.simulation.servo.state import StateLayout as StateLayout
from ropsim.simulation.simulate import SimulationOptions as SimulationOptions
from ropsim.simulation.simulate import simulate as simulate
from ropsim.simulation.watch import NobodyWatches as NobodyWatches
from ropsim.simulation.watch import RunView as RunView
from ropsim.simulation.watch import Watch as Watch
