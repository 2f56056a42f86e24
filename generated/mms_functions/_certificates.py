"""Proofs, up to bounds of the rounding, that equilibria are where they were found."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._charts import Chart, chart, equations
from ._flow import Flow
from ._paths import solve

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ._records import Equilibria

__all__ = ["certified"]


def certified(flow: Flow, coefficients: Any, found: Equilibria) -> NDArray[np.bool_]:
    """Whether Kantorovich's theorem proves that there is exactly one equilibrium close by.

    With η = |J⁻¹f|, β = |J⁻¹| and a bound L of the second derivatives, βLη ≤ ½ suffices
    (L. V. Kantorovich, 1948). Rounding errors of the residual are bounded by the moduli of its
    terms. At folds and other bifurcations nothing can be proved, since J is singular there.

    Parameters
    ----------
    flow : Flow
    coefficients : array_like
        Shape (..., terms).
    found : Equilibria
        At these coefficients.

    Returns
    -------
    numpy.ndarray
        Shape (..., k); False where there is no equilibrium.
    """
    b = found.amplitudes
    count = b.shape[-2]
    c = np.asarray(coefficients, dtype=np.complex128)[..., None, :]
    c = np.broadcast_to(c, (*b.shape[:-1], c.shape[-1])).reshape(-1, c.shape[-1])
    b, drift = b.reshape(-1, flow.n), found.drift.reshape(len(c), -1)
    there = np.isfinite(b).all(axis=-1)
    kinds, index = np.unique(b[there] != 0.0, axis=0, return_inverse=True)
    out, rows = np.zeros(len(c), dtype=bool), np.flatnonzero(there)
    for k, kind in enumerate(kinds):
        active = tuple(int(j) for j in np.flatnonzero(kind))
        own = rows[index.ravel() == k]
        if not active:
            # No term is left but constant ones.
            force = [m for m, (_, e) in enumerate(flow.terms) if not any(e)]
            out[own] = (c[own][:, force] == 0.0).all(axis=-1)
            continue
        place = chart(flow, active)
        rate = drift[own] @ np.array(place.parts).reshape(drift.shape[1], len(place.pivots))
        out[own] = _proved(place, c[own][:, list(place.columns)], b[own][:, list(active)], rate)
    return out.reshape(*found.amplitudes.shape[:-2], count)


def _sums(place: Chart, c: NDArray[Any], b: NDArray[Any], rate: NDArray[Any]) -> tuple[Any, Any]:
    """Sums of the moduli of all terms, and a bound of their second derivatives, per amplitude.

    Second derivatives by amplitudes k and l of Π B^α B̄^β are at most (α_k + β_k)(α_l + β_l)
    (+ the first factor once more, where k = l) times the product with two powers less.
    """
    flow, size = place.flow, np.abs(b)
    value, bend = np.zeros(b.shape), np.zeros(b.shape)
    for m, (j, e) in enumerate(flow.terms):
        degrees = [e[3 * k] + e[3 * k + 1] + abs(e[3 * k + 2]) for k in range(flow.n)]
        whole = np.abs(c[..., m]) * np.prod(size ** np.array(degrees), axis=-1)
        value[..., j] += whole
        for k, x in enumerate(degrees):
            for i, y in enumerate(degrees):
                count = x * (x + abs(e[3 * k + 2])) if i == k else x * y
                if i == k and x == 1 and e[3 * k + 2] == 0:
                    count = 0  # linear in this amplitude
                if count:
                    bend[..., j] += whole * count / (size[..., k] * size[..., i])
    if place.pivots:
        turn = np.abs(np.array(flow.symmetries, dtype=np.float64))
        value += (np.abs(rate) @ turn) * size
        bend += 2.0 * turn.sum(axis=0)
    return value, bend


def _proved(
    place: Chart, c: NDArray[Any], b: NDArray[Any], rate: NDArray[Any]
) -> NDArray[np.bool_]:
    with np.errstate(all="ignore"):
        f, matrices = equations(place, c, b, rate)
        value, bend = _sums(place, c, b, rate)
        d = matrices.shape[-1]
        inverse = solve(matrices, np.broadcast_to(np.eye(d), matrices.shape).copy())
        error = np.repeat(2.0 * value, 2, axis=-1) * 2.0**-52 * (8 + 2 * len(place.flow.terms))
        eta = (np.abs(inverse) @ (np.abs(f) + error)[..., None])[..., 0].max(axis=-1)
        beta = np.abs(inverse).sum(axis=-1).max(axis=-1)
        condition = beta * np.abs(matrices).sum(axis=-1).max(axis=-1)
        # Within 2η no amplitude changes by more than a tenth of itself, so no second derivative
        # by more than (11/10)^degree.
        degree = max((sum(map(abs, e)) for _, e in place.flow.terms), default=0)
        near = 4.0 * eta < 0.1 * np.abs(b).min(axis=-1)
        bound = 4.0 * d * bend.max(axis=-1) * 1.1**degree
        trusted = condition * d * 2.0**-52 < 1e-3
        return near & trusted & (1.01 * beta * bound * 1.01 * eta <= 0.5)
