"""The emitted `initial_amplitudes`: from coordinates and velocities at t = 0 to amplitudes."""

from __future__ import annotations

from ..ir import fresh
from ..uniform import uniform_motion
from .kernels import EmittedFunction, called
from .motion import motion_parameters
from .setting import Setting

__all__ = ["initial_function"]


def initial_function(setting: Setting) -> EmittedFunction:
    """The function `initial_amplitudes` of a case, beside its `response` and its `slow_flow`."""
    motion = uniform_motion(setting.case)
    arguments = motion_parameters(setting, motion)
    names, n = [p.name for p in arguments], motion.n
    q, v = fresh("q", names), fresh("v", names)
    slow = f"({{_slow_flow}}, {len(setting.parameters)}, {setting.flow.frame is None})"
    return EmittedFunction(
        name="initial_amplitudes",
        arguments=arguments,
        body=called("{initial_at}", ["{_MOTION}", "{_motion}", "{arguments}", q, v, slow]),
        returns="NDArray[np.complex128]",
        summary="Amplitudes at t = 0 of the motion with given coordinates and velocities there.",
        description="The solution of response(0, amplitudes) = q, and of its derivative along "
        "slow_flow = v, that goes over into that of order zero as the small parameters go to zero.",
        result=f"Shape (..., {n}), complex128; NaN where there is none near that of order zero, as "
        "far outside of the scaling, or where a harmonic resonates itself.",
        reference=None,
        uses=("initial_at",),
        leading=(
            (q, f"Coordinates at t = 0, shape (..., {n}), in the order of COORDINATES."),
            (v, f"Velocities at t = 0, shape (..., {n}), per second."),
        ),
    )
