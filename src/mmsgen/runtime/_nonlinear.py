"""What emitted functions of nonlinear slow flows do with their coefficients.

Every such module holds the terms of its slow flow, `Flow`, and a kernel for their coefficients; the
functions here evaluate them in batches: Jacobians, stability, equilibria, and their curves along
one parameter.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ._dual import array_slopes, real_at
from ._flow import Flow, jacobian, rates, spectrum
from ._records import Equilibria
from ._runtime import checked_amplitudes, evaluate, evaluate_array, refuse_masked
from ._slopes import eigenvalue_slopes, jacobian_slopes, slopes_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "backbone_at",
    "checked_amplitude",
    "drift_of",
    "equilibria_at",
    "jacobian_at",
    "response_along",
    "stability_at",
]

Kernel = Callable[..., Any]
Arguments = Sequence["NDArray[np.float64]"]


def coefficients_at(flow: Flow, kernel: Kernel, arguments: Arguments) -> NDArray[np.complex128]:
    """The coefficients of all terms, shape (..., terms)."""
    return evaluate_array(kernel, arguments, (len(flow.terms),))


def _points(flow: Flow, amplitudes: ArrayLike, c: NDArray[Any]) -> NDArray[np.complex128]:
    """Amplitudes that broadcast with the coefficients."""
    b = np.stack(checked_amplitudes(amplitudes, flow.n, missing=True), axis=-1)
    try:
        np.broadcast_shapes(b.shape[:-1], c.shape[:-1])
    except ValueError:
        raise ValueError(
            f"shapes that do not broadcast together: amplitudes {b.shape[:-1]} without their last "
            f"axis, parameters {c.shape[:-1]}"
        ) from None
    return b


def _missing(b: NDArray[Any]) -> NDArray[np.bool_]:
    """Which points are not there."""
    return np.asarray(np.isnan(b).any(axis=-1))


def drift_of(flow: Flow, c: NDArray[Any], b: NDArray[Any]) -> NDArray[np.float64]:
    """Rates along the symmetries that leave least of the motion, shape (..., symmetries).

    At an equilibrium nothing is left. With the speed F_j and the directions i k_j B_j these are the
    solution of a linear problem of least squares; a symmetry that does not move the point has the
    rate zero.
    """
    k = np.array(flow.symmetries, dtype=np.float64).reshape(-1, flow.n)
    speed = rates(flow, c, b)
    b = np.broadcast_to(b, speed.shape)
    normal = np.einsum("aj,bj,...j->...ab", k, k, np.abs(b) ** 2)
    right = np.einsum("aj,...j->...a", k, (b.conj() * speed).imag)
    known = np.asarray(np.isfinite(normal).all(axis=(-2, -1)) & np.isfinite(right).all(axis=-1))
    inverse = np.linalg.pinv(np.where(known[..., None, None], normal, 0.0), hermitian=True)
    found = np.einsum("...ab,...b->...a", inverse, np.where(known[..., None], right, 0.0))
    return np.where(known[..., None], found, np.nan)


def _moving(
    flow: Flow, kernel: Kernel, arguments: Arguments, b: NDArray[Any], missing: NDArray[np.bool_]
) -> NDArray[np.float64]:
    """Derivatives of the Jacobian by every parameter, the amplitudes fixed."""
    dc = array_slopes(kernel, arguments, len(flow.terms))[1]
    more = (1,) * (b.ndim + 1 - dc.ndim)  # axes of the amplitudes alone
    dc = dc.reshape(len(arguments), *more, *dc.shape[1:])
    turn = drift_of(flow, dc, b) if flow.symmetries else np.zeros(0)
    lost = missing | ~np.isfinite(dc).all(axis=-1)
    return np.where(lost[..., None, None], np.nan, jacobian_slopes(flow, dc, b, turn))


def jacobian_at(
    flow: Flow,
    kernel: Kernel,
    arguments: Arguments,
    amplitudes: ArrayLike,
    names: Sequence[str] = (),
) -> Any:
    """The Jacobian of the Cartesian slow flow, in a frame that drifts with the point.

    Parameters
    ----------
    flow : Flow
    kernel : callable
        Fills the coefficients of its terms.
    arguments : sequence of numpy.ndarray
        What it takes.
    amplitudes : array_like
        Shape (..., n); NaN gives NaN.
    names : sequence of str
        Of the arguments; empty where no derivatives are wanted.

    Returns
    -------
    numpy.ndarray, or (numpy.ndarray, dict)
        Shape (..., 2n, 2n), rows and columns u_1, v_1, u_2, … with B_j = (u_j + i v_j)/2; NaN
        where a coefficient is not finite. Derivatives are taken with the amplitudes fixed.
    """
    with np.errstate(all="ignore"):
        c = coefficients_at(flow, kernel, arguments)
        b = _points(flow, amplitudes, c)
        drift = drift_of(flow, c, b) if flow.symmetries else None
        found = jacobian(flow, c, b, drift)
        lost = _missing(b) | ~np.isfinite(c).all(axis=-1)
        found = np.where(lost[..., None, None], np.nan, found)
        if not names:
            return found
        change = _moving(flow, kernel, arguments, b, _missing(b))
    return found, dict(zip(names, change, strict=True))


def stability_at(
    flow: Flow,
    kernel: Kernel,
    arguments: Arguments,
    amplitudes: ArrayLike,
    names: Sequence[str] = (),
) -> Any:
    """Eigenvalues of the Jacobian, the largest real part first.

    Parameters
    ----------
    flow, kernel, arguments, amplitudes, names
        As for `jacobian_at`.

    Returns
    -------
    numpy.ndarray, or (numpy.ndarray, dict)
        Complex, shape (..., 2n); those that a symmetry makes zero are NaN, at the end. Derivatives
        are taken with the amplitudes fixed, and are NaN where eigenvalues meet.
    """
    with np.errstate(all="ignore"):
        c = coefficients_at(flow, kernel, arguments)
        b = _points(flow, amplitudes, c)
        drift = drift_of(flow, c, b) if flow.symmetries else None
        lost = _missing(b)[..., None]
        b = np.where(lost, 1.0, b)
        if not names:
            return np.where(lost, _NOTHING, spectrum(flow, c, b, drift))
        matrices = jacobian(flow, c, b, drift)
        change = _moving(flow, kernel, arguments, b, lost[..., 0])
        values, slopes = eigenvalue_slopes(flow, matrices, change, b, held=True)
    return np.where(lost, _NOTHING, values), dict(zip(names, slopes, strict=True))


_NOTHING = complex(np.nan, np.nan)


# --- curves ---------------------------------------------------------------------------------------


def backbone_at(
    kernel: Kernel, amplitude: ArrayLike, arguments: Arguments, names: Sequence[str]
) -> Any:
    """A formula in the real amplitude; with names also its derivatives.

    NaN where a divisor vanishes.

    Parameters
    ----------
    kernel : callable
        Of the amplitude and the arguments.
    amplitude : array_like
        Not negative.
    arguments : sequence of numpy.ndarray
    names : sequence of str
        Of the arguments; empty where no derivatives are wanted.

    Raises
    ------
    ValueError
        If the amplitude is not a finite real number, or negative, or the shapes do not broadcast.
    """
    a = checked_amplitude(amplitude, [x.shape for x in arguments])
    return real_at(_finite, kernel, [a, *arguments], names)


def _finite(kernel: Kernel, arguments: Arguments) -> Any:
    """One real number for each point, NaN where there is none."""
    value = evaluate(kernel, arguments)
    return np.where(np.isfinite(value), value, np.nan)[()]


def checked_amplitude(
    amplitude: ArrayLike, shapes: Sequence[tuple[int, ...]]
) -> NDArray[np.float64]:
    """An amplitude as an array.

    Raises
    ------
    ValueError
        If it is not a finite real number, or negative, or its shape does not broadcast with others.
    """
    refuse_masked("the amplitude", amplitude)
    a = np.asarray(amplitude)
    if a.dtype.kind not in "iuf" or not np.isfinite(a).all() or (a < 0.0).any():
        raise ValueError(f"the amplitude must be finite and not negative, got {amplitude!r}")
    a = a.astype(np.float64, copy=False)
    try:
        np.broadcast_shapes(a.shape, *shapes)
    except ValueError:
        others = ", ".join(map(str, shapes))
        raise ValueError(
            f"shapes that do not broadcast together: the amplitude {a.shape}, parameters {others}"
        ) from None
    return a


def response_along(
    flow: Flow,
    kernel: Kernel,
    arguments: Arguments,
    names: Sequence[str],
    over: str,
    gradient: bool = False,
) -> Any:
    """All equilibria along one parameter, as curves, with their bifurcations.

    Parameters
    ----------
    flow, kernel, arguments
        As for `jacobian_at`.
    names : sequence of str
        Of the arguments.
    over : str
        Which of them varies.
    gradient : bool
        Whether derivatives are wanted.

    Returns
    -------
    Response, or (Response, dict)
        The dictionary is name → `ResponseSlopes`.

    Raises
    ------
    ValueError
        If it is unknown, its values are not an array of one dimension, or another one is an array.
    """
    from ._branches import response_of  # as long to load as everything else

    if over not in names:
        raise ValueError(f"over must be one of {', '.join(names)}, got {over!r}")
    place = list(names).index(over)
    values = arguments[place]
    if values.ndim != 1:
        raise ValueError(
            f"{over}, which varies, must be an array of one dimension, got the shape {values.shape}"
        )
    for name, array in zip(names, arguments, strict=True):
        if name != over and array.size != 1:
            raise ValueError(
                f"only {over} may be an array, got the shape {array.shape} for {name}; give over= "
                "the name of the one that varies"
            )
    fixed = [a if k == place else a.reshape(()) for k, a in enumerate(arguments)]

    def coefficients(p: Any) -> NDArray[np.complex128]:
        own = [*fixed[:place], np.asarray(p, dtype=np.float64), *fixed[place + 1 :]]
        return coefficients_at(flow, kernel, own)

    with np.errstate(all="ignore"):
        found = response_of(flow, coefficients, values, name=over)
        if not gradient:
            return found
        from ._response_slopes import response_slopes  # as seldom used

        return found, response_slopes(flow, kernel, fixed, names, place, found)


# --- equilibria, and how they move with the parameters --------------------------------------------


def equilibria_at(
    solve: Callable[[Flow, Any], Equilibria],
    flow: Flow,
    kernel: Kernel,
    arguments: Arguments,
    names: Sequence[str],
) -> Any:
    """All equilibria; with names also their derivatives.

    Parameters
    ----------
    solve : callable
        Terms and coefficients → equilibria.
    flow, kernel, arguments
        As for `jacobian_at`.
    names : sequence of str
        Of the arguments; empty where no derivatives are wanted.

    Returns
    -------
    Equilibria, or (Equilibria, dict)
        The dictionary is name → `Slopes`.
    """
    with np.errstate(all="ignore"):
        found = solve(flow, coefficients_at(flow, kernel, arguments))
    if not names:
        return found
    return found, slopes_of(flow, kernel, arguments, names, found.amplitudes, found.drift)
