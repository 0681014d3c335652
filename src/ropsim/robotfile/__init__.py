"""The robot file `robots/NAME.toml`: a DH table with limits, masses, drives and looks to a robot."""

from ropsim.robotfile.estimated_dynamics import estimated_dynamics as estimated_dynamics
from ropsim.robotfile.places import robot_file_places as robot_file_places
from ropsim.robotfile.reading import read_robot_file as read_robot_file
from ropsim.robotfile.writing import write_robot_file as write_robot_file
