"""Readers of mesh formats: any bytes give corners of triangles or a finding, in bounded time and memory.

Nothing here opens a file or an address: what a mesh file refers to is not looked at. The reader of GLB is in
`mesh_formats.glb`; it needs a JSON decoder, which projects without GLB do not wait for.
"""

from ropsim.workbench.mesh_formats.obj import read_obj as read_obj
from ropsim.workbench.mesh_formats.ply import read_ply as read_ply
from ropsim.workbench.mesh_formats.soup import MOST_TRIANGLES as MOST_TRIANGLES
from ropsim.workbench.mesh_formats.soup import NO_TRIANGLES as NO_TRIANGLES
from ropsim.workbench.mesh_formats.soup import UNCOLOURED as UNCOLOURED
from ropsim.workbench.mesh_formats.soup import MeshFileError as MeshFileError
from ropsim.workbench.mesh_formats.soup import Soup as Soup
from ropsim.workbench.mesh_formats.stl import read_stl as read_stl
