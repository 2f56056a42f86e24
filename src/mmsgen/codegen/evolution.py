"""The emitted `evolution` and `beating`: linear slow flows from given initial amplitudes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import mpmath

from ..ir import fresh
from .exact import exact
from .kernels import AMPLITUDES, TIME, Constant, EmittedFunction, Kernel, Reference, called
from .numpy_target import wrapped
from .rounding import UNIT, rounded
from .setting import Setting, values_of

__all__ = ["evolution_functions"]

_BLOCKS = "_BLOCKS"


def evolution_functions(setting: Setting, flow: Kernel) -> tuple[EmittedFunction, ...]:
    """The functions `evolution` and `beating` of a case with a linear slow flow.

    Parameters
    ----------
    setting : Setting
    flow : Kernel
        That of `slow_flow`, from which they take the matrix.
    """
    names = [p.name for p in setting.parameters]
    n = len(setting.coordinates)
    t, amplitudes = fresh("t", names), fresh("amplitudes", names)
    start = (amplitudes, f"Those at t = 0, shape (..., {n}), in the order of COORDINATES.")
    common = [f"{{{_BLOCKS}}}", f"{{{flow.name}}}", "{arguments}"]

    def reference(point: Mapping[str, Any]) -> Reference:
        own = values_of(point, setting.parameters)
        values, error = _values(setting, flow, own, point[TIME], point[AMPLITUDES])
        given = tuple(point[AMPLITUDES])
        return Reference(own, (n,), values, (error,) * n, given, {"time": point[TIME]})

    evolution = EmittedFunction(
        name="evolution",
        arguments=setting.parameters,
        body=called("{evolution_at}", [*common, t, amplitudes]),
        returns="NDArray[np.complex128]",
        summary="Amplitudes at any time from those at t = 0.",
        description=(
            "The matrix exponential of the slow flow, in the frame A_j = B_j exp(i λ_j t), λ in "
            "FRAME: a closed form for blocks of one and two variables, scaling and squaring for "
            "larger ones; no eigenvectors, so that double eigenvalues do no harm."
        ),
        result=f"Shape (..., {n}), complex128, in the unit of the amplitudes.",
        reference=reference,
        uses=("evolution_at",),
        leading=((t, "Times, s; they broadcast with the other arguments."), start),
        constants=(_blocks(setting),),
    )
    beating = EmittedFunction(
        name="beating",
        arguments=setting.parameters,
        body=called("{beating_at}", [*common, amplitudes]),
        returns="Beating",
        summary="How amplitudes beat: period and largest modulus, from those at t = 0.",
        description=(
            "Closed forms where no mode decays: the sum of the moduli of the parts in each "
            "eigenvalue, which is the least upper bound of |B_j| unless three or more frequencies "
            "are commensurable. Else a maximum that is searched for in time."
        ),
        result=(
            f"period (s), largest, margin, each of shape (..., {n}). The period is NaN unless "
            "exactly two frequencies take part; largest is infinite where the amplitude grows "
            "without bound; margin is how much too small it may be, 0 for closed forms."
        ),
        reference=None,
        uses=("beating_at", "Beating"),
        leading=(start,),
        kind="Beating",
    )
    return evolution, beating


def _blocks(setting: Setting) -> Constant:
    assert setting.linear is not None
    rows = []
    for block in setting.linear.blocks:
        nodes = [f"({j}, {barred})" for j, barred in block.nodes]
        rows.append(f"({', '.join(nodes)}{',' if len(nodes) == 1 else ''})")
    inner = "\n".join(wrapped(rows, 8))
    items = (f"{len(setting.coordinates)}", f"(\n{inner}\n    )")
    meaning = "amplitudes (j, 0) and conjugates (j, 1) that move together"
    return Constant(_BLOCKS, "Linear", items, meaning)


def _values(
    setting: Setting, flow: Kernel, own: Mapping[str, Any], t: Any, amplitudes: Any
) -> tuple[tuple[Any, ...], Any]:
    """The amplitudes to the working precision, and a bound of the error of each."""
    assert setting.linear is not None
    n = len(setting.coordinates)
    values: list[Any] = [None] * n
    bound, first = mpmath.mpf(0), 0
    inexact = _matrix_error(flow, own, n)
    for block in setting.linear.blocks:
        m = len(block.nodes)
        s = mpmath.matrix(m, m)
        for i in range(m):
            for j in range(m):
                entry = setting.linear.matrix[first + i, first + j]
                s[i, j] = exact(entry, own) if entry != 0 else 0
        first += m
        x = [mpmath.conj(amplitudes[j]) if b else amplitudes[j] for j, b in block.nodes]
        moved = mpmath.expm(s * t) * mpmath.matrix(x)
        for (j, b), value in reversed(list(zip(block.nodes, moved, strict=True))):
            values[j] = mpmath.conj(mpmath.mpc(value)) if b else mpmath.mpc(value)
        # An error δS makes at most t e^{‖S‖t} ‖δS‖ of the exponential; the method itself some
        # units times its norm and the number of its squarings, of which ‖S‖t is a bound.
        size = mpmath.mnorm(s, "f") * abs(t)
        own_error = inexact * abs(t) + 64 * m * UNIT * (1 + size)
        start = mpmath.sqrt(mpmath.fsum(abs(c) ** 2 for c in x))
        bound = max(bound, own_error * mpmath.exp(size) * start)
    return tuple(values), bound


def _matrix_error(flow: Kernel, own: Mapping[str, Any], n: int) -> Any:
    """What rounding makes of the matrix that is taken out of `slow_flow`, in the Frobenius norm."""
    names = [symbol.name for symbol in flow.ir.arguments[:n]]
    total = mpmath.mpf(0)
    for k in range(n):
        for unit in (mpmath.mpc(1), mpmath.mpc(0, 1)):
            point = {name: unit if i == k else mpmath.mpc(0) for i, name in enumerate(names)}
            for rate in rounded(flow.ir, {**own, **point}).values():
                total += (rate.error + UNIT * abs(rate.value)) ** 2
    return mpmath.sqrt(2 * total)
