"""The cell file: `cell.toml` to a cell, every mistake with its place, and places of names in it."""

from ropsim.cellfile.cell import asked_in_cell_file as asked_in_cell_file
from ropsim.cellfile.cell import read_cell as read_cell
from ropsim.cellfile.meanings import NAMED as NAMED
from ropsim.cellfile.meanings import meaning_of as meaning_of
from ropsim.cellfile.new_cell import POINTER as POINTER
from ropsim.cellfile.new_cell import new_cell as new_cell
from ropsim.cellfile.new_cell import written_coordinates as written_coordinates
from ropsim.cellfile.places import controller_key_in_cell_file as controller_key_in_cell_file
from ropsim.cellfile.places import mesh_in_files as mesh_in_files
from ropsim.cellfile.places import place_in_cell_file as place_in_cell_file
from ropsim.cellfile.places import program_in_cell_file as program_in_cell_file
from ropsim.cellfile.robots.controller_limits import Limits as Limits
from ropsim.cellfile.robots.controller_limits import limits_section as limits_section
from ropsim.cellfile.robots.controller_limits import with_limits as with_limits
from ropsim.cellfile.robots.controller_limits import written_limits as written_limits
from ropsim.cellfile.robots.robot_files import is_foreign_file as is_foreign_file
from ropsim.cellfile.robots.robot_files import is_robot_file as is_robot_file
from ropsim.cellfile.robots.robot_files import robot_files as robot_files
