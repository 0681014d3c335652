"""Controllers with the model of the arm: computed torque, impedance, hybrid force."""

import numpy as np

from ropsim.blockdiagram import blocks as b
from ropsim.blockdiagram.diagram import Diagram
from ropsim.blockdiagram.kinds.drawing import Axes, Drawing, Given
from ropsim.blockdiagram.signals import Role


def computed_torque(axes: Axes, kp: Given, kd: Given, ki: Given = 0.0) -> Diagram:
    """Return D(q, qd, qdd_ref + kd·ė + kp·e + ki·∫e dt): each axis obeys ë + kd·ė + kp·e = 0 with ki = 0.

    J. Y. S. Luh, M. W. Walker, R. P. Paul: Resolved-acceleration control of mechanical manipulators, IEEE
    Trans. Automatic Control 25 (1980), 468-474. Friction is taken at the speed of the reference, the back-EMF
    of motors at the measured one.

    Args:
        axes: that it is for.
        kp: [1/s²].
        kd: [1/s].
        ki: [1/s³].
    """
    to = Drawing("computed_torque", axes)
    units = axes.units(Role.REFERENCE_ACCELERATION)
    error = to.difference("error", Role.REFERENCE_COORDINATE, Role.COORDINATE)
    parts = [to.signal(Role.REFERENCE_ACCELERATION), to.gain("stiffness", kp, error, units)]
    late = to.difference("speed_error", Role.REFERENCE_SPEED, Role.SPEED)
    parts.append(to.gain("damping", kd, late, units))
    if np.any(np.asarray(ki, float) != 0.0):
        held = to.inner("integral_out", units)
        parts.append(to.add(b.Integrator("integral", (error,), held, to.each("ki", ki), (0.0,), axes.period)))
    wanted = to.sum("acceleration", parts, (1,) * len(parts), units)
    motion = to.signal(Role.COORDINATE), to.signal(Role.SPEED), wanted, to.signal(Role.REFERENCE_SPEED)
    effort = to.inner("efforts", axes.efforts)
    to.add(b.ModelFeedForward("model", motion, effort, b.ModelKind.COMPUTED_TORQUE))
    to.put_out(effort)
    return to.done()


def impedance(axes: Axes, stiffness: Given, damping: Given) -> Diagram:
    """Return the controller that lets each axis be a spring with a damper about its reference.

    τ = g(q) + K·(q_ref - q) + D·(qd_ref - qd): under a constant force an axis deflects by force/stiffness
    (N. Hogan: Impedance control, J. Dyn. Sys. Meas. Control 107 (1985), 1-24, in joint coordinates). Dry
    friction of the drives is not made up for.

    Args:
        axes: that it is for.
        stiffness: K [N·m/rad | N/m], a number for each axis, or a matrix.
        damping: D [N·m·s/rad | N·s/m], in the same form.
    """
    to = Drawing("impedance", axes)
    error = to.difference("error", Role.REFERENCE_COORDINATE, Role.COORDINATE)
    late = to.difference("speed_error", Role.REFERENCE_SPEED, Role.SPEED)
    weight = to.inner("gravity_out", axes.efforts)
    to.add(b.ModelFeedForward("gravity", (to.signal(Role.COORDINATE),), weight, b.ModelKind.GRAVITY))
    parts = [weight, _linear(to, "stiffness", stiffness, error), _linear(to, "damping", damping, late)]
    to.put_out(to.sum("effort", parts, (1, 1, 1), axes.efforts))
    return to.done()


def _linear(to: Drawing, name: str, values: Given, signal: str) -> str:
    """Add a gain or a matrix."""
    if np.ndim(values) < 2:
        return to.gain(name, values, signal, to.axes.efforts)
    output = to.inner(f"{name}_out", to.axes.efforts)
    return to.add(b.MatrixGain(name, (signal,), output, to.matrix(name, values)))


def hybrid_force(
    axes: Axes,
    forced: tuple[bool, ...],
    efforts: Given,
    position: tuple[Given, Given],
    force: tuple[Given, Given],
) -> Diagram:
    """Return the controller that moves some axes and lets the others press with a certain effort.

    Force axes: τ = g(q) + τ_ref + kf·(τ_ref - τ_ext) + ki·∫(τ_ref - τ_ext) dt - d·qd with the effort τ_ext =
    τ - g(q) that the drives exert beyond gravity, as they are sensed at the joints; the others: τ = g(q) +
    kp·e + kd·ė (M. H. Raibert, J. J. Craig: Hybrid position/force control of manipulators, J. Dyn. Sys. Meas.
    Control 103 (1981), 126-133, with the axes of the arm as directions).

    Args:
        axes: that it is for.
        forced: which of them press.
        efforts: τ_ref of these [N·m | N].
        position: kp and kd of all axes; kd also damps those that press.
        force: kf, without unit, and ki [1/s], of those that press.
    """
    to = Drawing("hybrid_force", axes)
    press = np.asarray(forced, np.float64) * np.ones(axes.n)
    move = 1.0 - press
    kp, kd = (np.asarray(one, np.float64) * np.ones(axes.n) for one in position)
    units = axes.efforts
    weight = to.inner("gravity_out", units)
    to.add(b.ModelFeedForward("gravity", (to.signal(Role.COORDINATE),), weight, b.ModelKind.GRAVITY))
    error = to.difference("error", Role.REFERENCE_COORDINATE, Role.COORDINATE)
    parts = [weight, to.gain("stiffness", kp * move, error, units)]
    parts.append(
        to.gain("damping", kd * move, to.difference("speed_error", Role.REFERENCE_SPEED, Role.SPEED), units)
    )
    parts.append(to.gain("braking", -kd * press, to.signal(Role.SPEED), units))
    reference = to.inner("force_reference", units)
    to.add(b.Constant("force", (), reference, to.each("efforts", np.asarray(efforts, float) * press)))
    sensed = to.sum("sensed", (to.signal(Role.EFFORT), weight), (1, -1), units)
    pressing = to.gain("pressing", press, sensed, units)
    lacking = to.inner("force_loop_out", units)
    gains = tuple(
        to.each(name, np.asarray(one, float) * press) for name, one in zip(("kf", "ki"), force, strict=True)
    )
    loop = b.Pid(
        *(
            "force_loop",
            (reference, pressing, reference),
            lacking,
            gains[0],
            gains[1],
            (0.0,),
            (0.0,),
            (1.0,),
        ),
        *((0.0,), (), (), b.AntiWindup.NONE, (), axes.period),
    )
    parts.append(to.add(loop))
    to.put_out(to.sum("effort", parts, (1,) * len(parts), units))
    return to.done()
