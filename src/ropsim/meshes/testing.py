"""Door for tests: names behind the front of the package. Production code does not import it."""

from ropsim.meshes.formats import MOST_TRIANGLES as MOST_TRIANGLES
from ropsim.meshes.formats import UNCOLOURED as UNCOLOURED
from ropsim.meshes.formats import MeshFileError as MeshFileError
from ropsim.meshes.formats import Soup as Soup
from ropsim.meshes.formats import read_obj as read_obj
from ropsim.meshes.formats import read_ply as read_ply
from ropsim.meshes.formats import read_stl as read_stl
from ropsim.meshes.formats.collada import read_collada as read_collada
from ropsim.meshes.formats.glb import read_glb as read_glb
from ropsim.meshes.glb import glb_bytes as glb_bytes
from ropsim.meshes.reading import read_mesh as read_mesh
from ropsim.meshes.triangles import shaded as shaded
