"""Mechanisms: trees of bodies and joints, with couplings between joints and cuts of closed chains."""

from dataclasses import field, replace

from ropsim.flow import ParameterOrigin
from ropsim.model.drives.drive import Drive
from ropsim.model.geometry.elements import Shape
from ropsim.model.mechanism.links import BASE_LINK, PREVIOUS, Coupling, Joint, Link, LoopCut
from ropsim.model.mechanism.number_check import check_finite, check_numbers
from ropsim.model.mechanism.spring_numbers import check_springs
from ropsim.model.mechanism.springs import JointSpring, Spring
from ropsim.spatial import Array, Pose, frozen, record


@record
class Mechanism:
    """Bodies, the joints that move them, and the drives of the joints; immutable, shared by all runs.

    A joint moves the link of the same number; links are attached to each other by the parents of the joints,
    and a parent comes before its children. Users see and command the axes, n of them: limits, speeds, drives,
    home and recordings have an entry for each axis. All other coordinates follow through couplings.

    Attributes:
        name: short name.
        title: maker and model.
        joints: of the tree.
        links: the body moved by each joint.
        drives: drive of each axis, in the order of the axes, n of them; empty without drive data.
        home: coordinates of the axes in the rest position [rad | m], shape (n,).
        axes: numbers of the joints, from 0, that are driven, in the order in which users see them; each with
            a single freedom. Where none are given, all joints with one freedom that no coupling determines.
        couplings: coordinates that follow others.
        cuts: closed chains.
        gravity: acceleration of free fall in the base frame [m/s²], shape (3,).
        origins: where the numbers come from.
        base_shapes: shapes of the fixed part, in the base frame.
        springs: with dampers, between points of two bodies.
        joint_springs: with dampers, on coordinates of joints.

    Raises:
        ModelValueError: a limit, mass, inertia, placement or spring is not finite, or not positive where it
            must be.
    """

    name: str
    title: str
    joints: tuple[Joint, ...]
    links: tuple[Link, ...]
    drives: tuple[Drive, ...]
    home: Array
    axes: tuple[int, ...] = ()
    couplings: tuple[Coupling, ...] = ()
    cuts: tuple[LoopCut, ...] = ()
    gravity: Array = field(default_factory=lambda: frozen([0.0, 0.0, -9.81]))
    origins: tuple[ParameterOrigin, ...] = ()
    base_shapes: tuple[Shape, ...] = ()
    springs: tuple[Spring, ...] = ()
    joint_springs: tuple[JointSpring, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "home", frozen(self.home))
        object.__setattr__(self, "gravity", frozen(self.gravity))
        object.__setattr__(self, "joints", serial(self.joints))
        object.__setattr__(self, "axes", self.axes or _free_joints(self))
        check_numbers(self.joints, self.links, self.axes, self.drives)
        check_springs(self.springs, self.joint_springs)
        check_finite(f"the home position of `{self.name}`", self.home.tolist())
        check_finite(f"the gravity of `{self.name}`", self.gravity.tolist())

    def __repr__(self) -> str:
        """Return one line: names and number of axes; no arrays."""
        axes = "1 axis" if self.n == 1 else f"{self.n} axes"
        return f"<{type(self).__name__} {self.name}: {self.title}, {axes}>"

    @property
    def n(self) -> int:
        """Return the number of axes."""
        return len(self.axes)

    @property
    def axis_joints(self) -> tuple[Joint, ...]:
        """Return the joint of each axis, n of them."""
        return tuple(self.joints[number] for number in self.axes)

    @property
    def interface_link(self) -> int:
        """Return the number of the link that things are mounted on: the last one."""
        return len(self.joints) - 1

    @property
    def interface(self) -> Pose:
        """Return where on that link: the frame of the link itself."""
        return Pose()

    @property
    def lower_limits(self) -> Array:
        """Return the lower limits [rad | m], shape (n,)."""
        return frozen([joint.lower for joint in self.axis_joints])

    @property
    def upper_limits(self) -> Array:
        """Return the upper limits [rad | m], shape (n,)."""
        return frozen([joint.upper for joint in self.axis_joints])

    @property
    def max_speeds(self) -> Array:
        """Return the speed limits [rad/s | m/s], shape (n,)."""
        return frozen([joint.max_speed for joint in self.axis_joints])

    @property
    def max_accelerations(self) -> Array:
        """Return the acceleration limits [rad/s² | m/s²], shape (n,)."""
        return frozen([joint.max_acceleration for joint in self.axis_joints])

    @property
    def max_jerks(self) -> Array:
        """Return the jerk limits [rad/s³ | m/s³], shape (n,)."""
        return frozen([joint.max_jerk for joint in self.axis_joints])

    @property
    def max_efforts(self) -> Array:
        """Return the torque or force limits at the axes [N·m | N], shape (n,)."""
        return frozen([joint.max_effort for joint in self.axis_joints])


def serial(joints: tuple[Joint, ...]) -> tuple[Joint, ...]:
    """Return joints with their parents filled in: one that says `PREVIOUS` hangs on the link before it."""
    return tuple(
        replace(joint, parent=number - 1 if number else BASE_LINK) if joint.parent == PREVIOUS else joint
        for number, joint in enumerate(joints)
    )


def first_coordinates(joints: tuple[Joint, ...]) -> tuple[int, ...]:
    """Return the number of the first coordinate of each joint, and at the end that of all coordinates."""
    found = [0]
    for joint in joints:
        found.append(found[-1] + joint.type.freedoms)
    return tuple(found)


def _free_joints(mechanism: Mechanism) -> tuple[int, ...]:
    dependent = {coupling.dependent for coupling in mechanism.couplings}
    first = first_coordinates(mechanism.joints)
    return tuple(
        number
        for number, joint in enumerate(mechanism.joints)
        if joint.type.freedoms == 1 and first[number] not in dependent
    )
