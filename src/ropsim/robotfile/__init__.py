"""The robot file `robots/NAME.toml`: a DH table with limits, masses, drives and looks to a robot."""

from ropsim.robotfile.estimation.arm_facts import ArmFacts as ArmFacts
from ropsim.robotfile.estimation.estimated_dynamics import estimated_dynamics as estimated_dynamics
from ropsim.robotfile.estimation.estimated_dynamics import lacks_motors as lacks_motors
from ropsim.robotfile.estimation.torque_limits import TorqueTrust as TorqueTrust
from ropsim.robotfile.places import robot_file_places as robot_file_places
from ropsim.robotfile.reading import read_robot_file as read_robot_file
from ropsim.robotfile.writing import write_robot_file as write_robot_file
