"""Readers of mesh formats: any bytes lead to corners of triangles or a finding, in bounded time and memory.

Nothing here opens a file or an address: files that a mesh file refers to are not read. The reader of GLB is
in `formats.glb`, that of COLLADA in `formats.collada`; they need decoders of JSON and XML, which other
projects do not wait for.
"""

from ropsim.meshes.formats.obj import read_obj as read_obj
from ropsim.meshes.formats.ply import read_ply as read_ply
from ropsim.meshes.formats.soup import MOST_TRIANGLES as MOST_TRIANGLES
from ropsim.meshes.formats.soup import NO_TRIANGLES as NO_TRIANGLES
from ropsim.meshes.formats.soup import UNCOLOURED as UNCOLOURED
from ropsim.meshes.formats.soup import MeshFileError as MeshFileError
from ropsim.meshes.formats.soup import Soup as Soup
from ropsim.meshes.formats.stl import read_stl as read_stl
