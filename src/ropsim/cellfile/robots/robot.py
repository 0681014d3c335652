"""The robot of a cell file: model, start and changes of its controller."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ropsim import robots
from ropsim.cellfile import diagnostics as kinds
from ropsim.cellfile.robots.controller_files import read_entities, with_law_file
from ropsim.cellfile.robots.external_axes import ExternalAxes, read_external_axes
from ropsim.cellfile.robots.sensors import read_sensors, sensor_words
from ropsim.core import RopsimError
from ropsim.kinematics import follower_limits
from ropsim.model import (
    GAIN_NAMES,
    LAW_WORDS,
    ControllerFile,
    ControllerKind,
    ControllerModel,
    CorrectionLimits,
    JointType,
    LookAhead,
    OrientationMode,
    OriginKind,
    ParameterOrigin,
    PathDefaults,
    Rates,
    RobotModel,
    ShortLines,
    Station,
    Synchronisation,
    axes_words,
    gain_names,
    with_axis_limits,
)
from ropsim.spatial import Array, Pose, frozen, record
from ropsim.tomltext import NUMBER, SHARE, TIME, Quantity, Question, Sort, TomlTable, Units

_LIMITS = ("joint_speed", "joint_acceleration", "joint_jerk")
_PATH_KEYS = (
    "path_acceleration",
    "path_jerk",
    "orientation_speed",
    "orientation_acceleration",
    "orientation_jerk",
)
_GAIN = NUMBER.within(0.0, 1e6)
_SHARES = {"kf": NUMBER.within(0.0, 2.0)}
_SETTLE = TIME.within(0.0, 60.0)
_MOST_AHEAD = 1000  # moves
_NARROWEST = 1e-9  # [rad | m], least window of a fine stop
_WIDEST = 0.1  # [rad | m]
_GRAVITY_ROUNDING = 1e-12  # [m/s²], of a rotation about the vertical
_ROUNDING = 1e-9  # [rad | m], start written with decimals may touch a limit


@record
class RobotSection:
    """Contents of `[robot]` and `[controller]`.

    Attributes:
        model: the arm, with the external axes of its station.
        controller: its controller.
        start: joint coordinates at time 0 [rad | m], shape (n,).
    """

    model: RobotModel
    controller: ControllerModel
    start: Array


def read_robot(
    table: TomlTable, arm: RobotModel | None, settings: TomlTable, X_WB: Pose, units: Units
) -> RobotSection | None:
    """Return the robot of a section under the controller that its settings change.

    Keys of other readers (`base`, `tool`) must have been read before; both sections are finished here.
    Returns None where there is no robot.

    Args:
        table: section `[robot]` or `[stations.NAME]`.
        arm: that it names (`RobotLibrary`); None where it is missing, unknown or wrong.
        settings: section `[controller]` or `[stations.NAME.controller]`.
        X_WB: base frame in the world frame, of the track where the arm is on one; a tilted base turns gravity
            in the base frame.
        units: units of the file.
    """
    external = read_external_axes(table, units)
    loaded = None if arm is None else _joined(table, arm, settings, external, X_WB)
    return _section(table, settings, loaded, X_WB, units)


def read_driven(
    table: TomlTable, model: RobotModel | None, settings: TomlTable, X_WB: Pose, units: Units
) -> RobotSection | None:
    """Return a model that the file describes under its standard controller; see `read_robot`.

    Args:
        table: section `[stations.NAME]`.
        model: with drives, None where its description is wrong.
        settings: section `[stations.NAME.controller]`.
        X_WB: base frame in the world frame.
        units: units of the file.
    """
    loaded = None if model is None else (model, robots.default_controller(model, _rates(settings)))
    return _section(table, settings, loaded, X_WB, units)


def _section(
    table: TomlTable,
    settings: TomlTable,
    loaded: tuple[RobotModel, ControllerModel] | None,
    X_WB: Pose,
    units: Units,
) -> RobotSection | None:
    """Return a model under the controller that the settings change; both tables are finished."""
    override = table.number("speed_override", SHARE, 1.0)
    start_given = "start" in table
    if loaded is None:
        table.finish()
        return None
    model, controller = loaded
    start = _start(table, model, units) if start_given else model.home
    table.finish()
    controller = replace(_controller(settings, controller, model, units), speed_override=override)
    model = _limited(settings, model, units)
    settings.finish()
    return RobotSection(_with_base(model, X_WB), controller, start)


def _joined(
    table: TomlTable, arm: RobotModel, settings: TomlTable, external: ExternalAxes, X_WB: Pose
) -> tuple[RobotModel, ControllerModel] | None:
    """Return an arm and its external axes with their standard controller at the rates of `settings`."""
    try:
        model = external.joined(arm, X_WB)
        return model, robots.default_controller(model, _rates(settings))
    except RopsimError as error:
        key = "robot" if "robot" in table.values else "model"
        table.findings.items.append(replace(error.diagnostic, span=table.value_span(key)))
        return None


def _rates(settings: TomlTable) -> Rates:
    standard = robots.STANDARD_RATES
    return Rates(
        settings.integer("control_hz", 50, 20_000, standard.control_hz),
        settings.integer("interpolation_ticks", 1, 1000, standard.interpolation_ticks),
        settings.integer("plant_steps", 1, 100, 1) if "plant_steps" in settings.values else None,
    )


def _with_base(model: RobotModel, X_WB: Pose) -> RobotModel:
    """Return the model with gravity as the base feels it; the model itself where the base is upright."""
    gravity = X_WB.rotation().T @ model.gravity
    if np.allclose(gravity, model.gravity, rtol=0.0, atol=_GRAVITY_ROUNDING):
        return model
    return replace(model, gravity=gravity)


def under_gravity(station: Station, gravity: Array) -> Station:
    """Return a station whose robot is under another acceleration of free fall.

    Args:
        station: with its base frame.
        gravity: in the world frame [m/s²], shape (3,).
    """
    in_base = station.X_WB.rotation().T @ gravity
    return replace(station, robot=replace(station.robot, gravity=frozen(in_base)))


def _start(table: TomlTable, model: RobotModel, units: Units) -> Array:
    start = _per_joint(table, "start", _coordinates(model, units), model.home, model)
    for k, joint in enumerate(model.axis_joints):
        if joint.lower - _ROUNDING <= start[k] <= joint.upper + _ROUNDING:
            continue
        quantity = _coordinates(model, units)[k]
        found, lower, upper = (
            quantity.show(value / quantity.scale) for value in (float(start[k]), joint.lower, joint.upper)
        )
        message = f"joint `{joint.name}` would start at {found}, its limits are {lower} and {upper}"
        hint = "without `start` the arm starts at its home position"
        table.findings.add(kinds.START_OUTSIDE_LIMITS, table.value_span("start", k), message, hint)
    coupled = follower_limits(model)
    for joint, value, beyond in zip(
        coupled.joints, coupled.values(start).tolist(), coupled.excess(start).tolist(), strict=True
    ):
        if beyond:
            quantity = units.turn if joint.measure is JointType.REVOLUTE else units.position
            found, lower, upper = (
                quantity.show(one / quantity.scale) for one in (value, joint.lower, joint.upper)
            )
            message = (
                f"joint `{joint.name}`, which follows the axes, would start at {found}, "
                f"its limits are {lower} and {upper}"
            )
            hint = "without `start` the arm starts at its home position"
            table.findings.add(kinds.START_OUTSIDE_LIMITS, table.value_span("start"), message, hint)
    return frozen(start)


def _controller(
    table: TomlTable, controller: ControllerModel, model: RobotModel, units: Units
) -> ControllerModel:
    windows = [quantity.within(_NARROWEST, _WIDEST) for quantity in _coordinates(model, units)]
    controller = _with_stated_law(table, controller, model)
    sensors = read_sensors(table.table("sensors"), model, units, controller.rates)
    words = [sensor_words(sensors)] if sensors.sensors else []
    measured = tuple(ParameterOrigin("sensors", OriginKind.DERIVED, one) for one in words)
    own, built_in = read_entities(table.table("entities"))
    names = gain_names(controller.gains)
    given = [name for name in names if name in table]
    given_path = [name for name in _PATH_KEYS if name in table]
    gains = {
        name: _per_joint(
            table, name, [_SHARES.get(name, _GAIN)] * model.n, getattr(controller.gains, name), model
        )
        for name in names
    }
    if not isinstance(controller.gains, ControllerFile):
        controller = replace(controller, gains=type(controller.gains)(**gains))
    return replace(
        controller,
        path=_path(table, controller.path, units),
        in_position=_per_joint(table, "in_position", windows, controller.in_position, model),
        settle_timeout=table.number("settle_timeout", _SETTLE, controller.settle_timeout),
        settle_time=table.number("settle_time", _SETTLE, controller.settle_time),
        look_ahead=_look_ahead(table, controller.look_ahead),
        via_zone=table.number("via_zone", units.position.within(0.0, 1.0), controller.via_zone),
        orientation=OrientationMode(
            table.choice("orientation", [one.value for one in OrientationMode], controller.orientation.value)
        ),
        ptp=Synchronisation(
            table.choice("ptp", [one.value for one in Synchronisation], controller.ptp.value)
        ),
        short_lines=ShortLines(
            table.choice("short_lines", [one.value for one in ShortLines], controller.short_lines.value)
        ),
        correction=_correction(table, controller.correction, units),
        origins=tuple(
            _with_given(origin, given_path if origin.parameters == robots.PATH_LIMITS else given)
            for origin in controller.origins
        )
        + measured,
        sensors=sensors,
        entities=own,
        built_in=built_in,
    )


def _with_stated_law(table: TomlTable, controller: ControllerModel, model: RobotModel) -> ControllerModel:
    """Return the standard controller under the stated law, else under that to which the stated gains belong.

    Gains are those of loops joint by joint where an arm may have them, unless one is among them that only its
    standard law has, such as `kd`.
    """
    if "file" in table:
        return with_law_file(table, controller)
    if controller.kind is ControllerKind.IDEAL:
        return controller
    kinds = {LAW_WORDS[kind]: kind for kind in robots.possible_laws(model)}
    standard, fixed = LAW_WORDS[controller.kind], LAW_WORDS[ControllerKind.CASCADED_P_PI]
    own = set(gain_names(controller.gains)) - set(GAIN_NAMES)
    belongs = any(name in table for name in GAIN_NAMES) and not any(name in table for name in own)
    law = table.choice(
        "law",
        list(kinds),
        fixed if belongs and fixed in kinds else standard,
        "a law of your own is in a file: `file = ...`",
    )
    if law == standard or law not in kinds:
        return controller
    return robots.controller_under(model, controller.rates, kinds[law])


def _limited(table: TomlTable, model: RobotModel, units: Units) -> RobotModel:
    """Return the model with joint limits from the settings; the standard gains stay."""
    known = (model.max_speeds, model.max_accelerations, model.max_jerks)
    limits = [
        _per_joint(table, key, [units.rate(joint.measure, order) for joint in model.axis_joints], own, model)
        for order, (key, own) in enumerate(zip(_LIMITS, known, strict=True), start=1)
    ]
    given = [key for key in _LIMITS if key in table]
    if not given:
        return model
    origin = ParameterOrigin(", ".join(given), OriginKind.DERIVED, "as in the cell file")
    return replace(with_axis_limits(model, *limits), origins=(*model.origins, origin))


def _with_given(origin: ParameterOrigin, given: Sequence[str]) -> ParameterOrigin:
    """Return the origin of gains or path limits, naming those from the cell file."""
    if not given:
        return origin
    return replace(origin, source=f"{', '.join(given)} as in the cell file; the others {origin.source}")


def _look_ahead(table: TomlTable, standard: LookAhead) -> LookAhead:
    """Return the look-ahead; a number in the file is that of the real controller, and counts alone."""
    given = "look_ahead" in table
    moves = table.integer("look_ahead", 0, _MOST_AHEAD, standard.moves)
    return LookAhead(moves, 0.0) if given else standard


def _path(table: TomlTable, path: PathDefaults, units: Units) -> PathDefaults:
    return PathDefaults(
        table.number("path_speed", units.path(1, 20.0), path.speed),
        table.number("path_acceleration", units.path(2, 1e3), path.acceleration),
        table.number("path_jerk", units.path(3, 1e5), path.jerk),
        table.number("orientation_speed", units.orientation(1, 100.0), path.orientation_speed),
        table.number("orientation_acceleration", units.orientation(2, 1e4), path.orientation_acceleration),
        table.number("orientation_jerk", units.orientation(3, 1e6), path.orientation_jerk),
    )


def _correction(table: TomlTable, limits: CorrectionLimits, units: Units) -> CorrectionLimits:
    return CorrectionLimits(
        table.number("correction_size", units.position.within(1e-6, 0.05), limits.size),
        table.number("correction_speed", units.path(1, 0.1), limits.speed),
        table.number("correction_acceleration", units.path(2, 20.0), limits.acceleration),
    )


def _coordinates(model: RobotModel, units: Units) -> list[Quantity]:
    """Return how the coordinate of each joint is written: an angle or a length."""
    return [
        units.turn if joint.measure is JointType.REVOLUTE else units.position for joint in model.axis_joints
    ]


def _per_joint(
    table: TomlTable, key: str, quantities: Sequence[Quantity], default: Array, model: RobotModel
) -> Array:
    """Return one number per joint [SI], shape (n,)."""
    quantity = quantities[0] if len(set(quantities)) == 1 else None
    table.ask(key, Question(Sort.NUMBERS, quantity, tuple(default.tolist()), count=len(quantities)))
    if key not in table:
        return default
    value = table.values[key]
    if not isinstance(value, list):
        table.wrong_type((key,), value, "a list of numbers")
        return default
    if len(value) != len(quantities):
        table.wrong_count((key,), value, axes_words(model))
        return default
    pairs = zip(value, quantities, default.tolist(), strict=True)
    return frozen(
        [
            table.number_at((key, k), item, quantity, fallback)
            for k, (item, quantity, fallback) in enumerate(pairs)
        ]
    )
