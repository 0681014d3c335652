"""Laws of the part library: every kind, model and parameter."""

from collections.abc import Iterator

import numpy as np
import pytest

from ropsim.kinematics import joint_frames
from ropsim.model import Box, Cylinder, OriginKind, Polyline, Shape
from ropsim.parts import (
    PART_KINDS,
    LibraryPart,
    PartKind,
    PartValueError,
    Product,
    UnknownPartError,
    Use,
    library_part,
)
from ropsim.spatial import Array
from ropsim.views.testing import facets

KINDS = list(PART_KINDS.values())
PRODUCTS = [(kind, product) for kind in KINDS for product in kind.products]
TOOLS = [kind for kind in KINDS if kind.use is Use.TOOL]
MOST_SHAPES = 200


def extremes(kind: PartKind) -> Iterator[dict[str, float]]:
    """Yield values with one parameter at an end of its range, and those that bound it moved along."""
    for parameter in kind.parameters:
        for end in (parameter.low, parameter.high):
            values = {parameter.name: end}
            complete = kind.defaults() | values
            for bound in kind.at_most:
                if not bound.is_kept(complete):
                    values[bound.large if bound.small == parameter.name else bound.small] = end
            yield values


CORNERS = [(kind, values) for kind in KINDS for values in extremes(kind)]


NEEDED = {
    ("vacuum_gripper", "pitch"): {"cups_x": 2.0, "cup_diameter": 0.01},
    ("belt_conveyor", "support_distance"): {"length": 6.0},
    ("roller_conveyor", "support_distance"): {"length": 6.0},
}
"""What a parameter of a kind needs to show."""


def bodies(part: LibraryPart) -> list[Shape]:
    return [*part.shapes, *part.moving_shapes, *finger_shapes(part)]


def finger_shapes(part: LibraryPart) -> list[Shape]:
    fingers = part.gripper.fingers if part.gripper else None
    return [shape for link in fingers.mechanism.links for shape in link.shapes] if fingers else []


def points(part: LibraryPart) -> Array:
    """Return the corners of all solids of a tool or object, fingers open, shape (k, 3)."""
    found = [facets(shape).reshape(-1, 3) for shape in (*part.shapes, *part.moving_shapes)]
    fingers = part.gripper.fingers if part.gripper else None
    if fingers:
        frames = joint_frames(fingers.mechanism, np.array([fingers.opened]))
        found += [
            facets(shape).reshape(-1, 3) @ X[:3, :3].T + X[:3, 3]
            for X, link in zip(frames[:2], fingers.mechanism.links, strict=True)
            for shape in link.shapes
        ]
    return np.concatenate(found)


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_a_kind_says_what_it_is_and_every_default_lies_in_its_range(kind: PartKind) -> None:
    assert PART_KINDS[kind.name] is kind
    assert kind.title
    assert kind.frame.endswith(".")
    assert len({one.name for one in kind.parameters}) == len(kind.parameters)
    for one in kind.parameters:
        assert one.low < one.high
        assert one.default is None or one.low <= one.default <= one.high
        assert one.meaning.endswith(".")
        assert one.source or one.origin is OriginKind.ESTIMATED
    assert kind.conflict(kind.defaults()) is None


@pytest.mark.parametrize(("kind", "product"), PRODUCTS, ids=lambda one: one.name)
def test_a_product_cites_its_source_and_gives_parameters_of_its_kind(
    kind: PartKind, product: Product
) -> None:
    assert product.source
    assert product.values
    ranges = {one.name: (one.low, one.high) for one in kind.parameters}
    given = {**product.estimates, **product.values}
    assert len(given) == len(product.values) + len(product.estimates)
    assert all(ranges[name][0] <= value <= ranges[name][1] for name, value in given.items())
    assert kind.conflict(kind.defaults(product)) is None
    part = library_part(kind.name, product.name)
    assert kind.use is not Use.TOOL or part.load.mass == product.values.get("mass", part.load.mass)


@pytest.mark.parametrize(
    ("kind", "values"), CORNERS, ids=lambda one: one.name if isinstance(one, PartKind) else str(one)
)
def test_every_parameter_can_be_at_either_end_of_its_range(kind: PartKind, values: dict[str, float]) -> None:
    part = library_part(kind.name, "", **values)
    shapes = bodies(part)
    assert 0 < len(shapes) <= MOST_SHAPES
    for shape in shapes:
        assert isinstance(shape.solid, Polyline) or np.linalg.norm(facets(shape), axis=2).max() > 0.0
        if isinstance(shape.solid, Box):
            assert min(shape.solid.size) > 0.0
    principal = np.linalg.eigvalsh(part.load.inertia)
    assert principal[0] >= 0.0
    assert principal[2] <= principal[0] + principal[1] + 1e-12


@pytest.mark.parametrize(("kind", "values"), CORNERS, ids=lambda one: str(one)[:40])
def test_a_parameter_changes_the_part(kind: PartKind, values: dict[str, float]) -> None:
    (name, value), *_ = values.items()
    others = NEEDED.get((kind.name, name), {})
    if kind.defaults().get(name) != value:
        assert library_part(kind.name, "", **others, **values) != library_part(kind.name, "", **others)


@pytest.mark.parametrize("kind", TOOLS, ids=lambda kind: kind.name)
def test_mass_and_centre_of_mass_are_those_of_the_parameters(kind: PartKind) -> None:
    heavy = library_part(kind.name, mass=3.0)
    assert heavy.load.mass == 3.0
    ends = points(heavy)
    assert np.all(heavy.load.com > ends.min(axis=0))
    assert np.all(heavy.load.com < ends.max(axis=0))
    light = library_part(kind.name, mass=1.5)
    assert light.load.com == pytest.approx(heavy.load.com)
    assert 2.0 * light.load.inertia == pytest.approx(heavy.load.inertia)


@pytest.mark.parametrize("kind", ["two_finger_gripper", "vacuum_gripper"])
def test_a_given_centre_of_mass_holds(kind: str) -> None:
    assert library_part(kind, com=0.063).load.com == pytest.approx([0.0, 0.0, 0.063])


@pytest.mark.parametrize("stroke", [0.014, 0.08, 0.145])
def test_fingers_open_by_the_stroke_and_close_on_each_other(stroke: float) -> None:
    part = library_part("two_finger_gripper", stroke=stroke)
    assert part.gripper is not None
    assert part.gripper.fingers is not None
    assert part.X_MT is not None
    fingers = part.gripper.fingers
    for q, gap in ((fingers.opened, stroke), (fingers.closed, 0.0)):
        frames = joint_frames(fingers.mechanism, np.array([q]))
        sides = [
            np.concatenate([facets(shape).reshape(-1, 3) for shape in link.shapes]) @ X[:3, :3].T + X[:3, 3]
            for X, link in zip(frames[:2], fingers.mechanism.links, strict=True)
        ]
        assert sides[0][:, 1].min() == pytest.approx(gap / 2.0)
        assert sides[1][:, 1].max() == pytest.approx(-gap / 2.0)


def test_the_tcp_is_between_the_pads_and_the_fingers_reach_beyond_it() -> None:
    part = library_part("two_finger_gripper", grip_depth=0.02)
    assert part.X_MT is not None
    assert points(part)[:, 2].max() == pytest.approx(part.X_MT.position[2] + 0.02)
    assert part.X_MT.position[:2] == pytest.approx([0.0, 0.0])
    flush = library_part("two_finger_gripper", grip_depth=0.0)
    assert flush.X_MT is not None
    assert flush.X_MT.position[2] == pytest.approx(part.X_MT.position[2] + 0.02)
    assert points(flush)[:, 2].max() == pytest.approx(points(part)[:, 2].max())


@pytest.mark.parametrize("kind", ["vacuum_gripper", "flange"])
def test_the_tcp_is_at_the_far_end_of_a_tool_without_fingers(kind: str) -> None:
    part = library_part(kind)
    assert part.X_MT is not None
    assert part.X_MT.position[2] == pytest.approx(points(part)[:, 2].max())


def test_a_vacuum_gripper_has_its_cups_in_rows_and_columns() -> None:
    one, six = library_part("vacuum_gripper"), library_part("vacuum_gripper", cups_x=3, cups_y=2, pitch=0.1)
    assert len(six.shapes) - len(one.shapes) == 2 * 5
    lips = points(six)
    lips = lips[lips[:, 2] > lips[:, 2].max() - 1e-9]
    assert lips[:, 0].max() == pytest.approx(0.1 + 0.02)
    assert lips[:, 1].max() == pytest.approx(0.05 + 0.02, rel=1e-3)


def test_a_single_cup_has_no_pitch() -> None:
    cup = library_part("vacuum_gripper", cup_diameter=0.1)
    ends = points(cup)
    lips = ends[ends[:, 2] > ends[:, 2].max() - 1e-9]
    assert lips[:, 0].max() == pytest.approx(0.05)
    assert library_part("vacuum_gripper", cup_diameter=0.1, cups_x=2, pitch=0.1).shapes


@pytest.mark.parametrize(
    ("model", "distance"), [("franka_hand", 0.1034), ("robotiq_2f_85", None), ("franka_cobot_pump", 0.105)]
)
def test_the_tcp_of_a_product_is_the_published_one(model: str, distance: float | None) -> None:
    """`tcp_xyz` of Franka's descriptions of its end effectors."""
    kind = PART_KINDS["vacuum_gripper" if "pump" in model else "two_finger_gripper"]
    part, product = library_part(kind.name, model), kind.product(model)
    assert part.X_MT is not None
    if distance is None:
        assert kind.tcp_origin(product) is OriginKind.ESTIMATED
    else:
        assert part.X_MT.position == pytest.approx([0.0, 0.0, distance])
        assert kind.tcp_origin(product) is OriginKind.PUBLISHED
        assert kind.tcp_origin() is OriginKind.ESTIMATED


@pytest.mark.parametrize("tcp", [0.06, 0.15, 1.0])
@pytest.mark.parametrize("grip_depth", [0.0, 0.012, 0.05])
def test_the_housing_is_made_for_a_given_tcp(tcp: float, grip_depth: float) -> None:
    part = library_part("two_finger_gripper", tcp=tcp, grip_depth=grip_depth)
    assert part.X_MT is not None
    assert part.X_MT.position == pytest.approx([0.0, 0.0, tcp])
    assert points(part)[:, 2].max() == pytest.approx(tcp + grip_depth)
    assert all(min(one.solid.size) > 0.0 for one in bodies(part) if isinstance(one.solid, Box))
    cups = library_part("vacuum_gripper", tcp=tcp)
    assert points(cups)[:, 2].max() == pytest.approx(tcp)


def test_the_edge_of_a_flange_is_the_margin_away_from_the_pitch_circle() -> None:
    for margin in (0.001, 0.005, 0.02):
        plate, *_ = library_part("flange", margin=margin).shapes
        across = np.hypot(*facets(plate).reshape(-1, 3)[:, :2].T).max()
        assert across == pytest.approx(0.025 + margin)
    assert library_part("flange") == library_part("flange", margin=0.0065)


def test_a_flange_with_large_screws_on_a_small_circle_has_a_centring_ring() -> None:
    part = library_part("flange", pitch_circle=0.02, thread=0.02)
    assert part.load.mass > 0.0
    assert np.isfinite(points(part)).all()


@pytest.mark.parametrize("diameter", [0.1, 0.8, 4.0])
def test_a_turntable_stays_within_its_diameter_and_its_mark_is_seen(diameter: float) -> None:
    part = library_part("turntable", diameter=diameter, drum_diameter=0.05)
    *plates, mark = part.moving_shapes
    corners = facets(mark).reshape(-1, 3)
    away = np.hypot(*corners[:, :2].T)
    assert away.max() == pytest.approx(diameter / 2.0)
    assert np.hypot(*points(part)[:, :2].T).max() == pytest.approx(diameter / 2.0, rel=1e-3)
    below = [one for one in plates if facets(one)[..., 2].max() < -1e-9]
    assert all(np.hypot(*facets(one).reshape(-1, 3)[:, :2].T).max() < away.max() - 0.005 for one in below)
    assert below


def test_the_rollers_of_a_conveyor_are_level_and_no_further_apart_than_the_pitch() -> None:
    part = library_part("roller_conveyor", length=3.0, height=0.75, pitch=0.12, roller_diameter=0.06)
    corners = points(part)
    assert (corners[:, 2].min(), corners[:, 2].max()) == pytest.approx((-0.75, 0.0))
    assert (corners[:, 0].min(), corners[:, 0].max()) == pytest.approx((0.0, 3.0))
    rollers = [one for one in part.shapes if isinstance(one.solid, Cylinder)]
    places = sorted(float(one.pose.position[0]) for one in rollers)
    steps = np.diff(places)
    assert steps == pytest.approx(np.full(len(steps), steps[0]))
    assert 0.12 * (1.0 - 1.0 / len(steps)) <= steps[0] <= 0.12
    assert (places[0], places[-1]) == pytest.approx((0.03, 2.97))


def test_a_parameter_without_a_value_keeps_any_bound() -> None:
    kind = PART_KINDS["two_finger_gripper"]
    values = {name: value for name, value in kind.defaults().items() if name != "finger_length"}
    assert kind.conflict(values | {"grip_depth": 0.2}) is None
    assert kind.conflict(kind.defaults() | {"grip_depth": 0.2}) is not None


def test_a_flange_has_its_screws_on_the_pitch_circle_of_its_designation() -> None:
    part = library_part("flange", "iso_9409_1_100_6_m8")
    heads = [shape.pose.position for shape in part.shapes if np.hypot(*shape.pose.position[:2]) > 1e-6]
    assert len(heads) == 6
    assert [np.hypot(*place[:2]) for place in heads] == pytest.approx([0.05] * 6)


@pytest.mark.parametrize(
    ("model", "size", "mass"),
    [
        ("", (1.2, 0.8, 0.144), 25.0),
        ("eur_1", (1.2, 0.8, 0.144), 25.0),
        ("eur_2", (1.2, 1.0, 0.144), 33.0),
        ("eur_3", (1.0, 1.2, 0.144), 29.0),
        ("eur_6", (0.8, 0.6, 0.144), 9.5),
    ],
)
def test_a_pallet_has_the_size_and_mass_of_the_standard(
    model: str, size: tuple[float, ...], mass: float
) -> None:
    part = library_part("eur_pallet", model)
    corners = points(part)
    assert corners.max(axis=0) - corners.min(axis=0) == pytest.approx(size)
    assert corners[:, 2].min() == pytest.approx(0.0)
    assert part.load.mass == mass


def test_a_eur_pallet_has_five_boards_nine_blocks_and_boards_of_22_mm() -> None:
    sizes = [shape.solid.size for shape in library_part("eur_pallet").shapes if isinstance(shape.solid, Box)]
    boards = [size for size in sizes if size[2] == pytest.approx(0.022)]
    blocks = [size for size in sizes if size[2] == pytest.approx(0.078)]
    assert (len(boards), len(blocks)) == (5 + 3 + 3, 9)
    deck = sorted(round(size[1], 3) for size in boards[:5])
    assert deck == [0.1, 0.1, 0.145, 0.145, 0.145]


@pytest.mark.parametrize(
    ("kind", "size"),
    [("fence", (3.0, None, 2.0)), ("table", (1.2, 0.8, 0.85)), ("belt_conveyor", (None, None, 0.8))],
)
def test_an_object_is_as_large_as_its_parameters_say(kind: str, size: tuple[float | None, ...]) -> None:
    corners = points(library_part(kind))
    found = corners.max(axis=0) - corners.min(axis=0)
    margin = 0.07 if kind == "fence" else 1e-9  # foot plates
    assert all(one is None or abs(one - own) <= margin for one, own in zip(size, found, strict=True))


def test_the_belt_is_level_with_the_base_frame_and_stands_on_the_floor() -> None:
    corners = points(library_part("belt_conveyor", length=3.0, height=0.75))
    assert corners[:, 2].max() == pytest.approx(0.0)
    assert corners[:, 2].min() == pytest.approx(-0.75)
    top = corners[corners[:, 2] > -1e-9]
    assert (top[:, 0].min(), top[:, 0].max()) == pytest.approx((0.025, 2.975))


@pytest.mark.parametrize(
    ("kind", "model", "values", "words"),
    [
        ("two_finger_griper", "", {}, "did you mean `two_finger_gripper`?"),
        ("two_finger_gripper", "franka_hnd", {}, "did you mean `franka_hand`?"),
        ("fence", "", {"lenght": 1.0}, "did you mean `length`?"),
    ],
)
def test_an_unknown_name_is_refused_with_a_near_one(
    kind: str, model: str, values: dict[str, float], words: str
) -> None:
    with pytest.raises(UnknownPartError) as refused:
        library_part(kind, model, **values)
    assert refused.value.diagnostic.code == "X925"
    assert refused.value.diagnostic.hint == words


@pytest.mark.parametrize(
    ("kind", "values", "words"),
    [
        ("fence", {"length": 100.0}, "`length` of `fence` is 100, allowed is 0.3 to 12"),
        ("vacuum_gripper", {"cups_x": 2.5}, "`cups_x` of `vacuum_gripper` is 2.5, allowed is a whole number"),
        ("vacuum_gripper", {"cups_x": float("nan")}, "allowed is a whole number from 1 to 4"),
        ("fence", {"length": float("nan")}, "`length` of `fence` is nan"),
        ("vacuum_gripper", {"cup_diameter": 0.1, "cups_y": 2.0}, "is 0.1, above `pitch`, which is 0.08"),
    ],
)
def test_a_value_that_does_not_fit_is_refused(kind: str, values: dict[str, float], words: str) -> None:
    with pytest.raises(PartValueError) as refused:
        library_part(kind, "", **values)
    assert refused.value.diagnostic.code == "X924"
    assert words in refused.value.diagnostic.message
