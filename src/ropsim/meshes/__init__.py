"""Mesh files: read once, as GLB bytes under their own hash; meshes that cannot be drawn are findings."""

from ropsim.meshes.library import MeshLibrary as MeshLibrary
from ropsim.meshes.library import load_meshes as load_meshes
from ropsim.meshes.points import mesh_points as mesh_points
from ropsim.meshes.reading import MESH_FORMATS as MESH_FORMATS
from ropsim.meshes.reading import mesh_ending as mesh_ending
from ropsim.meshes.stl_writing import stl_bytes as stl_bytes
