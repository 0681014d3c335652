"""A robot in its rest position as a picture: parallel light and view, a shadow on the floor, edges dark."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from math import cos, radians, sin
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from ropsim.core import frozen_dataclass
from ropsim.kinematics import joint_frames, strut_frames
from ropsim.model import Body, RobotModel, Shape, Strut, cylinder_bodies, link_name
from ropsim.spatial import Array, fingerprint
from ropsim.views.picture.depth_buffer import DepthBuffer
from ropsim.views.picture.facets import facets
from ropsim.views.picture.png import png_bytes
from ropsim.views.scene.arm import base_shapes, link_shapes

DRAWING = "1"
"""Changes whenever the same robot is drawn in another way."""
_LIGHT = np.array([0.35, -0.55, 0.76])
_FILL = np.array([-0.6, -0.3, 0.3])
_AMBIENT, _KEY, _BACK = 0.42, 0.55, 0.16
_EDGE = 0.62  # share of the light at an edge
_STEP = 0.02  # of depth that makes an edge, as a share of the picture
_SHADOW = 0.3  # opacity of the shadow

Placed: TypeAlias = tuple[Array, tuple[Shape, ...]]
"""Frame of a body in the base frame, shape (4, 4), and its shapes."""


@frozen_dataclass
class PictureOptions:
    """How a robot is seen.

    Attributes:
        width: of the picture, in points; it is as high as wide.
        azimuth: of the eye about the vertical, from x to y [deg].
        elevation: of the eye over the floor [deg].
        finer: times that it is drawn finer before points are averaged.
    """

    width: int = 480
    azimuth: float = -58.0
    elevation: float = 16.0
    finer: int = 3


DEFAULT = PictureOptions()


def picture_print(robot: RobotModel, options: PictureOptions = DEFAULT) -> str:
    """Return a key that changes with the picture of a robot, not with its masses and limits."""
    shapes = tuple(link.shapes for link in robot.links)
    places = tuple((one.type, one.placement, one.offset, one.parent) for one in robot.joints)
    cylinders = tuple(_cylinders(robot))
    moved = (robot.home, robot.axes, robot.couplings)
    return fingerprint((DRAWING, options, robot.base_shapes, shapes, places, moved, *cylinders))


def robot_png(robot: RobotModel, options: PictureOptions = DEFAULT) -> bytes:
    """Return a picture of a robot as a PNG file, on a transparent ground.

    A robot whose shapes have no triangles is drawn by hubs at its joints and rods between them.
    """
    words = {"Title": robot.name, "Source": picture_print(robot, options)}
    return bodies_png(_bodies(_axes(robot) if has_no_shapes(robot) else robot), words, options)


def has_no_shapes(robot: RobotModel) -> bool:
    """Return whether a robot has no shape with triangles: none at all, or meshes, which are other files."""
    return not any(len(facets(shape)) for _, shapes in _bodies(robot) for shape in shapes)


def _axes(robot: RobotModel) -> RobotModel:
    """Return a robot whose shapes are hubs and rods."""
    bare = replace(robot, base_shapes=(), links=tuple(replace(link, shapes=()) for link in robot.links))
    links = tuple(
        replace(link, shapes=link_shapes(bare, number)) for number, link in enumerate(bare.links, start=1)
    )
    return replace(bare, base_shapes=base_shapes(bare), links=links)


def bodies_png(
    bodies: Iterable[Placed], words: Mapping[str, str], options: PictureOptions = DEFAULT
) -> bytes:
    """Return a picture of bodies as a PNG file, on a transparent ground.

    Args:
        bodies: frame in the base frame, shape (4, 4), and shapes of each.
        words: texts that are written into the file, by keyword.
        options: how they are seen.
    """
    scene, colours, numbers = _scene(bodies)
    size = options.width * options.finer
    view, scale, shift = _view(scene, options, size)
    flat = np.stack((scale, -scale, scale)) * (scene @ view.T) + shift
    buffer = DepthBuffer(size, size)
    buffer.draw(flat)
    shadow = DepthBuffer(size, size)
    fallen = scene - np.multiply.outer(scene[..., 2], _LIGHT / _LIGHT[2])  # along the light on to the floor
    shadow.draw(np.stack((scale, -scale, scale)) * (fallen @ view.T) + shift)
    pixels = _shaded(buffer, shadow, _lit(scene, colours), numbers)
    mean = pixels.reshape(options.width, options.finer, options.width, options.finer, 4).mean(axis=(1, 3))
    return png_bytes(_rounded(mean), dict(words))


def _scene(bodies: Iterable[Placed]) -> tuple[Array, Array, Array]:
    """Return triangles in the base frame, their colours from 0 to 1, and the number of the body of each."""
    found = [
        (facets(shape) @ X[:3, :3].T + X[:3, 3], _colour(shape), body)
        for body, (X, shapes) in enumerate(bodies)
        for shape in shapes
    ]
    triangles = np.concatenate([one for one, _, _ in found])
    colours = np.concatenate([np.tile(colour, (len(one), 1)) for one, colour, _ in found])
    return triangles, colours, np.concatenate([np.full(len(one), body) for one, _, body in found])


def _bodies(robot: RobotModel) -> Iterator[Placed]:
    """Yield base, links and cylinders at home: frame in the base frame, and shapes."""
    frames = joint_frames(robot, robot.home)
    yield np.eye(4), robot.base_shapes
    for X, link in zip(frames, robot.links, strict=False):
        yield X, link.shapes
    for body in _cylinders(robot):
        assert isinstance(body.mover, Strut)
        yield strut_frames(robot, body.mover, frames[np.newaxis])[0], body.shapes


def _cylinders(robot: RobotModel) -> Iterator[Body]:
    names = tuple(link_name(number) for number in range(len(robot.joints) + 1))
    return cylinder_bodies(robot, robot.name, names)


def _colour(shape: Shape) -> Array:
    return np.array(list(bytes.fromhex(shape.colour.removeprefix("#")))) / 255.0


def _view(scene: Array, options: PictureOptions, size: int) -> tuple[Array, float, Array]:
    """Return axes of the picture in the base frame as rows, points per metre, and where the base is."""
    a, e = radians(options.azimuth), radians(options.elevation)
    eye = np.array([cos(e) * cos(a), cos(e) * sin(a), sin(e)])
    right = np.array([-sin(a), cos(a), 0.0])
    view = np.stack((right, np.cross(eye, right), eye))
    seen = scene.reshape(-1, 3) @ view.T
    low, high = seen.min(axis=0), seen.max(axis=0)
    scale = 0.9 * size / float((high - low)[:2].max())
    middle = 0.5 * (low + high)
    shift = np.array([0.5 * size - scale * middle[0], 0.5 * size + scale * middle[1], 0.0])
    return view, scale, shift


def _lit(scene: Array, colours: Array) -> Array:
    """Return the colour of each triangle in the light (Lambert 1760)."""
    normals = np.cross(scene[:, 1] - scene[:, 0], scene[:, 2] - scene[:, 0])
    normals = normals / np.linalg.norm(normals, axis=1, keepdims=True)
    key, fill = (np.clip(normals @ (one / np.linalg.norm(one)), 0.0, 1.0) for one in (_LIGHT, _FILL))
    return np.asarray(
        np.clip(colours * (_AMBIENT + _KEY * key + _BACK * fill)[:, None] + 0.06 * key[:, None], 0, 1)
    )


def _shaded(buffer: DepthBuffer, shadow: DepthBuffer, lit: Array, bodies: Array) -> Array:
    """Return the points of the picture: colour, times opacity, and opacity, shape (n, n, 4)."""
    there = buffer.seen >= 0
    pixels = np.zeros((*buffer.seen.shape, 4))
    pixels[..., 3] = _SHADOW * _blurred((shadow.seen >= 0).astype(float), max(len(there) // 90, 1))
    colour = lit[buffer.seen[there]]
    colour[_edges(buffer, bodies)[there]] *= _EDGE
    pixels[there] = np.column_stack((colour, np.ones(len(colour))))
    return pixels


def _edges(buffer: DepthBuffer, bodies: Array) -> npt.NDArray[np.bool_]:
    """Return where two bodies meet, or one is far behind the other."""
    body = np.where(buffer.seen >= 0, bodies[buffer.seen], -1)
    depth = np.where(np.isfinite(buffer.depth), buffer.depth, -1e9)
    found = np.zeros(body.shape, bool)
    for axis in (0, 1):
        near = np.roll(body, 1, axis), np.roll(depth, 1, axis)
        found |= (body != near[0]) | (np.abs(depth - near[1]) > _STEP * len(body))
    return found


def _blurred(mask: Array, reach: int) -> Array:
    """Return a mask with soft edges: means over squares, three times over."""
    for _ in range(3):
        for axis in (0, 1):
            sums = np.cumsum(np.concatenate((mask, np.zeros_like(mask.take(range(reach), axis))), axis), axis)
            mask = (
                sums.take(range(reach, sums.shape[axis]), axis) - sums.take(range(mask.shape[axis]), axis)
            ) / reach
    return mask


def _rounded(pixels: Array) -> npt.NDArray[np.uint8]:
    """Return points with their colour apart from their opacity, as whole numbers to 255."""
    opacity = np.maximum(pixels[..., 3:], 1e-9)
    return np.asarray(
        np.rint(255.0 * np.concatenate((pixels[..., :3] / opacity, pixels[..., 3:]), -1)), np.uint8
    )
