"""The JSON part of a GLB file, as far as triangles need it (glTF 2.0)."""

from typing import Annotated

import msgspec

from ropsim.meshes.formats.soup import damaged

LARGEST = 8_000_000
"""Longest JSON part that is read [bytes]; triangles are in the binary part."""

READ = (
    "KHR_mesh_quantization",
    "KHR_texture_",
    "KHR_materials_",
    "KHR_lights_",
    "EXT_texture_",
    "MSFT_texture_",
)
"""Beginnings of extensions without which, or with which, the triangles are the same."""

Place = Annotated[int, msgspec.Meta(ge=0, lt=2**31)]


class Buffer(msgspec.Struct, rename="camel"):
    """Bytes; the file's own binary chunk if there is no address."""

    uri: str | None = None


class View(msgspec.Struct, rename="camel"):
    """A part of a buffer [bytes]."""

    buffer: Place
    byte_length: Place
    byte_offset: Place = 0
    byte_stride: Place = 0


class Accessor(msgspec.Struct, rename="camel"):
    """Numbers in a view."""

    component_type: int
    count: Place
    type: str
    buffer_view: Place | None = None
    byte_offset: Place = 0
    normalized: bool = False
    sparse: object = None


class Primitive(msgspec.Struct, rename="camel"):
    """Triangles, or points and lines."""

    attributes: dict[str, Place]
    indices: Place | None = None
    material: Place | None = None
    mode: int = 4


class Mesh(msgspec.Struct, rename="camel"):
    """Primitives that are placed together."""

    primitives: list[Primitive]


class Paint(msgspec.Struct, rename="camel"):
    """Colour of a material, linear red, green, blue and opaqueness."""

    base_color_factor: tuple[float, float, float, float] | None = None
    base_color_texture: object = None


class Material(msgspec.Struct, rename="camel"):
    """Material of a primitive."""

    pbr_metallic_roughness: Paint = msgspec.field(default_factory=Paint)


class Node(msgspec.Struct, rename="camel"):
    """A mesh, placed in the frame of the node above."""

    mesh: Place | None = None
    children: list[Place] = msgspec.field(default_factory=list)
    matrix: Annotated[list[float], msgspec.Meta(min_length=16, max_length=16)] | None = None
    translation: tuple[float, float, float] = (0.0, 0.0, 0.0)
    rotation: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)
    scale: tuple[float, float, float] = (1.0, 1.0, 1.0)


class Scene(msgspec.Struct, rename="camel"):
    """The nodes that stand on the ground."""

    nodes: list[Place] = msgspec.field(default_factory=list)


class Document(msgspec.Struct, rename="camel"):
    """The whole JSON part."""

    scene: Place = 0
    scenes: list[Scene] = msgspec.field(default_factory=list)
    nodes: list[Node] = msgspec.field(default_factory=list)
    meshes: list[Mesh] = msgspec.field(default_factory=list)
    materials: list[Material] = msgspec.field(default_factory=list)
    accessors: list[Accessor] = msgspec.field(default_factory=list)
    buffer_views: list[View] = msgspec.field(default_factory=list)
    buffers: list[Buffer] = msgspec.field(default_factory=list)
    extensions_required: list[str] = msgspec.field(default_factory=list)


def read_document(text: bytes) -> Document:
    """Return the JSON part of a GLB file.

    Raises:
        MeshFileError: it is not a document, is too long, or needs an extension that hides the triangles.
    """
    if len(text) > LARGEST:
        found = f"has a description of {len(text) / 1e6:.0f} MB, at most {LARGEST / 1e6:.0f} MB are read"
        raise damaged(found, "export it without what is not geometry")
    try:
        document = msgspec.json.decode(text, type=Document)
    except (ValueError, RecursionError) as error:
        raise damaged("cannot be read as GLB") from error
    for name in document.extensions_required:
        if not name.startswith(READ):
            found = f"needs the extension `{name[:60]}`, which is not read"
            raise damaged(found, "export it without compression of meshes")
    return document
