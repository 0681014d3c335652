"""Triangles as GLB bytes (glTF 2.0, binary): one mesh, nothing that leads out of the file."""

import json
import struct

from ropsim.meshes.triangles import Triangles

_FLOAT, _UINT, _BYTE = 5126, 5125, 5121  # component types of the glTF standard
_ATTRIBUTES, _INDICES = 34962, 34963  # buffer targets
_JSON, _BIN = 0x4E4F534A, 0x004E4942


def glb_bytes(triangles: Triangles) -> bytes:
    """Return a GLB file; equal triangles have equal bytes."""
    columns = [("POSITION", triangles.points.astype("<f4"), "VEC3", _FLOAT)]
    columns.append(("NORMAL", triangles.normals.astype("<f4"), "VEC3", _FLOAT))
    if triangles.colours is not None:
        columns.append(("COLOR_0", triangles.colours, "VEC4", _BYTE))
    columns.append(("", triangles.faces.astype("<u4").reshape(-1), "SCALAR", _UINT))
    accessors: list[dict[str, object]] = []
    views: list[dict[str, object]] = []
    attributes: dict[str, int] = {}
    body = b""
    for number, (name, values, sort, component) in enumerate(columns):
        content = values.tobytes()
        target = _ATTRIBUTES if name else _INDICES
        views.append({"buffer": 0, "byteOffset": len(body), "byteLength": len(content), "target": target})
        accessor: dict[str, object] = {
            "bufferView": number,
            "componentType": component,
            "count": len(values),
            "type": sort,
        }
        if name == "POSITION":
            accessor |= {"min": values.min(axis=0).tolist(), "max": values.max(axis=0).tolist()}
        if name == "COLOR_0":
            accessor["normalized"] = True
        if name:
            attributes[name] = number
        accessors.append(accessor)
        body += content
    header = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": attributes, "indices": len(columns) - 1}]}],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": len(body)}],
    }
    return _container(json.dumps(header, separators=(",", ":"), allow_nan=False).encode(), body)


def _container(header: bytes, body: bytes) -> bytes:
    header += b" " * (-len(header) % 4)
    body += b"\0" * (-len(body) % 4)
    length = 12 + 8 + len(header) + 8 + len(body)
    return b"".join(
        [
            struct.pack("<4sII", b"glTF", 2, length),
            struct.pack("<II", len(header), _JSON),
            header,
            struct.pack("<II", len(body), _BIN),
            body,
        ]
    )
