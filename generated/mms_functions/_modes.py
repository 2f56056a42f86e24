"""Free motions without damping: normal modes, of which one amplitude is given.

Their frequencies over that amplitude are the backbone curves of the responses. Such motions are
equilibria but for a drift along the symmetry that a shift in time is. They fill curves; the
terms that ask for an amplitude (`_families`) make points of these, which paths find like other
equilibria.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._charts import chart
from ._families import EXACT, selecting
from ._flow import Flow, rates, spectrum
from ._many_amplitudes import arranged, check_size, with_active
from ._nonlinear import checked_amplitude
from ._records import Backbone
from ._runtime import evaluate_array
from ._systems import patterns

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import ArrayLike, NDArray

__all__ = ["in_the_open", "modes_at", "modes_of"]

NEUTRAL = 1e-6
"""Growth, over the largest eigenvalue, that rounding makes of none where two of them meet: about
the square root of the precision."""


def modes_of(flow: Flow, coefficients: Any, amplitude: Any, of: int) -> Backbone:
    """All periodic free motions of the conservative part in which one amplitude is given.

    Of terms that no phase enters only the imaginary part counts, so that their damping is left
    out.

    Parameters
    ----------
    flow : Flow
        Without forces.
    coefficients : array_like
        Shape (..., terms).
    amplitude : array_like
        a = 2|B_of|, not negative; broadcasts with the leading axes of the coefficients.
    of : int
        Which amplitude that is.

    Returns
    -------
    Backbone
        Complete as `equilibria_of_many` is; NaN where a coefficient is not finite, and where the
        amplitude is zero. Its ``detuning`` is NaN.

    Raises
    ------
    ValueError
        If no motion keeps its amplitude, since terms that a phase enters dissipate; if there are
        too many to be listed, as `equilibria_of_many` says.
    """
    c = np.asarray(coefficients, dtype=np.complex128)
    a = np.asarray(amplitude, dtype=np.float64)
    shape = np.broadcast_shapes(c.shape[:-1], a.shape)
    flat = np.broadcast_to(c, (*shape, c.shape[-1])).reshape(-1, c.shape[-1])
    flat = np.where(_without_phase(flow), 1j * flat.imag, flat)
    half = np.broadcast_to(0.5 * a, shape).reshape(-1)
    rows = np.flatnonzero(np.isfinite(flat).all(axis=1) & (half > 0.0))
    g = len(flow.symmetries)
    found = [(rows[:0], np.zeros((0, flow.n), complex), np.zeros((0, g)))]
    with np.errstate(all="ignore"):
        for active in patterns(flow):
            place = chart(flow, active)
            if of not in active or len(place.drifts) != 1:
                continue  # without it, or a torus of several frequencies
            solve = _alone if len(active) == 1 else _together
            found.append(solve(flow, active, flat, half, rows, of))
        which, b, drift = (np.concatenate(x) for x in zip(*found, strict=True))
        points = arranged(flow, flat, shape, which, b, drift)
        growth = _growth(flow, np.reshape(flat, (*shape, 1, -1)), points.amplitudes, points.drift)
        turns = np.array(flow.symmetries, dtype=np.float64).reshape(g, flow.n)
        shift = np.where(points.amplitudes == 0.0, np.nan, points.drift @ turns)
    return Backbone(points.amplitudes, shift, np.full(growth.shape, np.nan), growth)


def _without_phase(flow: Flow) -> NDArray[np.bool_]:
    """Which terms of equation j are B_j times a function of the moduli."""
    return np.array(
        [all(e[3 * k] - e[3 * k + 1] == (k == j) for k in range(flow.n)) for j, e in flow.terms],
        dtype=bool,
    )


Found = tuple[Any, Any, Any]


def _alone(
    flow: Flow, active: tuple[int, ...], c: Any, half: Any, rows: NDArray[np.int64], of: int
) -> Found:
    """All others at rest: the rate is what its equation says."""
    place = chart(flow, active)
    b = np.zeros((len(rows), flow.n), dtype=np.complex128)
    b[:, of] = half[rows]
    rate = (rates(flow, c[rows], b)[:, of] / half[rows]).imag / place.flow.symmetries[0][0]
    return rows, b, rate[:, None] * np.array(place.mixing)


def _together(
    flow: Flow, active: tuple[int, ...], c: Any, half: Any, rows: NDArray[np.int64], of: int
) -> Found:
    """Several amplitudes, by the equation that asks for one of them."""
    square = half[rows] ** 2
    asking, asked = selecting(flow, c[rows], of, square, active)
    check_size(asking, (active,))
    which, b, drift = with_active(asking, active, asked, np.arange(len(rows)))
    moving = (np.abs(b[:, list(active)]) > 0.0).all(axis=1)
    exact = np.abs(np.abs(b[:, of]) ** 2 - square[which]) < EXACT * square[which]
    if (moving & ~exact).any() and not (moving & exact).any():
        raise ValueError(
            "free motions lose or gain energy in terms that couple phases, so that none has a "
            "constant amplitude: give the parameters of damping, or of self-excitation, as zero"
        )
    kept = moving & exact
    return rows[which[kept]], b[kept], drift[kept]


def _growth(flow: Flow, c: Any, b: NDArray[Any], drift: NDArray[Any]) -> NDArray[np.float64]:
    """The largest real part; one zero is there at least, that along the curve."""
    values = spectrum(flow, c, b, drift)
    size = np.where(np.isnan(values), 0.0, np.abs(values)).max(axis=-1)
    growth = np.where(np.isnan(values), -np.inf, values.real).max(axis=-1)
    growth = np.where(growth <= NEUTRAL * size, 0.0, growth)
    return np.where(np.isnan(b).any(axis=-1), np.nan, growth)


def in_the_open(found: Backbone, frame: Any, pull: NDArray[np.float64]) -> Backbone:
    """Frequencies instead of drifts in the frame of the slow flow, and the detunings of a force.

    Parameters
    ----------
    found : Backbone
        From `modes_of`.
    frame : array_like
        Rates λ_j at which the frame turns without a force, shape (..., 1, n) or (n,).
    pull : numpy.ndarray
        dλ_j by the detuning of the force; empty where there is none.
    """
    detuning = found.detuning
    if len(pull):
        # The one drift along the symmetry that a shift in time is; the largest part tells it.
        along = np.where(np.isnan(found.shift), 0.0, found.shift)
        detuning = (along @ pull) / (np.isfinite(found.shift) @ pull**2)
        off = (
            np.abs(along - detuning[..., None] * pull)
            > 1e-9 * np.abs(along).max(axis=-1)[..., None]
        )
        detuning = np.where((off & np.isfinite(found.shift)).any(axis=-1), np.nan, detuning)
    return found._replace(shift=found.shift + frame, detuning=detuning)


def modes_at(
    flow: Flow,
    pull: Sequence[float],
    kernel: Callable[..., Any],
    arguments: Sequence[NDArray[np.float64]],
    amplitude: ArrayLike,
    coordinates: Sequence[str],
    of: str,
) -> Backbone:
    """Free motions in which one amplitude is given, for emitted functions.

    Parameters
    ----------
    flow : Flow
        Without forces.
    pull : sequence of float
        As for `in_the_open`.
    kernel : callable
        Fills the coefficients of its terms, and after them the rates at which the frame turns.
    arguments : sequence of numpy.ndarray
        What it takes.
    amplitude : array_like
    coordinates : sequence of str
    of : str
        Which of them has that amplitude.

    Raises
    ------
    ValueError
        If `of` is no coordinate, or as for `checked_amplitude` and `modes_of`.
    """
    if of not in coordinates:
        raise ValueError(f"of must be one of {', '.join(coordinates)}, got {of!r}")
    count = len(flow.terms)
    a = checked_amplitude(amplitude, [x.shape for x in arguments])
    with np.errstate(all="ignore"):
        values = evaluate_array(kernel, arguments, (count + flow.n,))
        place = list(coordinates).index(of)
        found = modes_of(flow, values[..., :count], a, place)
        frame = values[..., None, count:].real
        return in_the_open(found, frame, np.array(pull, dtype=np.float64))
