"""Slow flows that conserve a sum Σ ν_j |B_j|², and their equilibria, which fill curves.

Where all parts of d/dt Σ ν_j |B_j|² = Σ ν_j 2 Re(B̄_j F_j) cancel, for some real ν, one of the
equations follows from the others: equilibria with these amplitudes other than zero are never
isolated, not even among the complex ones. So it is with undamped free oscillators, whose normal
modes have any amplitude. So it is with flows that run backwards on conjugate amplitudes, all
coefficients being imaginary, and with their equilibria whose phases are 0 and π: n equations for n
amplitudes and a rate of drift.

Terms that ask for an amplitude, η(ρ − |B_k|²)B_j, pick the points of these curves at which
|B_k|² = ρ. They would change the sum at the rate 2η(ρ − |B_k|²) Σ ν_j|B_j|², which is zero at
equilibria; to real amplitudes of flows that run backwards they add a real part, of which there is
no other.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._charts import chart
from ._flow import Flow

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["EXACT", "backwards", "conserved", "selecting"]

NOTHING = 1e-13
"""What is left where parts cancel, over the largest of them: roundings."""
EXACT = 1e-9
"""Relative error of |B_k|² at a point of a curve; far below what is off where there is none."""


def _identity(flow: Flow) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
    """Of each term of Σ ν_j 2 Re(B̄_j F_j): its monomial, and whether that is conjugated.

    A monomial is its harmonics r − s and degrees; of a pair of conjugates one stands for both.
    """
    places: dict[tuple[int, ...], int] = {}
    which, sign = [], []
    for j, e in flow.terms:
        turn = [e[3 * k] - e[3 * k + 1] - (k == j) for k in range(flow.n)]
        degree = [sum(e[3 * k : 3 * k + 3]) + (k == j) for k in range(flow.n)]
        lead = next((x for x in turn if x), 0)
        own = tuple(-x for x in turn) if lead < 0 else tuple(turn)
        which.append(places.setdefault((*own, *degree), len(places)))
        sign.append((lead > 0) - (lead < 0))
    return np.array(which), np.array(sign), np.array([j for j, _ in flow.terms])


def conserved(flow: Flow, active: tuple[int, ...], c: NDArray[Any]) -> NDArray[np.float64]:
    """The weights ν of a sum that is conserved while the other amplitudes are zero.

    Parameters
    ----------
    flow : Flow
    active : tuple of int
    c : numpy.ndarray
        Coefficients of the flow, shape (K, terms).

    Returns
    -------
    numpy.ndarray
        Shape (K, active), of length one; NaN where there is none.
    """
    place = chart(flow, active)
    own = c[:, list(place.columns)]
    out = np.full((len(c), len(active)), np.nan)
    if place.columns:
        rows = np.flatnonzero(_undamped(place.flow, own))
        out[rows] = _weights(place.flow, own[rows])
    return out


def _undamped(flow: Flow, c: NDArray[Any]) -> NDArray[np.bool_]:
    """Where the linear term of some amplitude does not change its modulus."""
    found = np.zeros(len(c), dtype=bool)
    for j in range(flow.n):
        plain = (j, tuple(int(k == 3 * j) for k in range(3 * flow.n)))
        if plain not in flow.terms:
            return np.ones(len(c), dtype=bool)
        value = c[:, flow.terms.index(plain)]
        found |= np.abs(value.real) <= NOTHING * np.abs(value)
    return found


def _weights(flow: Flow, c: NDArray[Any]) -> NDArray[np.float64]:
    """Null vectors of the parts of Σ ν_j 2 Re(B̄_j F_j), real and imaginary."""
    which, sign, row = _identity(flow)
    count = int(which.max()) + 1
    matrix, largest = np.zeros((2, len(c), 2 * count, flow.n))
    for m, value in enumerate(c.T):
        for part, x in enumerate((value.real, sign[m] * value.imag)):
            matrix[:, 2 * which[m] + part, row[m]] += x
            at = largest[:, 2 * which[m] + part, row[m]]
            np.maximum(at, np.abs(value), out=at)
    # Every part over its size, in units of the monomials and of the weights.
    unit = np.ones((len(c), 1, flow.n))
    for axis in (2, 1, 2):
        size = largest.max(axis=axis, keepdims=True)
        size = np.where(size > 0.0, size, 1.0)
        matrix, largest = matrix / size, largest / size
        unit = unit / size if axis == 1 else unit
    _, s, v = np.linalg.svd(matrix)
    least = np.zeros(len(c)) if s.shape[1] < flow.n else s[:, -1]
    found = v[:, -1, :] * unit[:, 0]
    found /= np.linalg.norm(found, axis=1, keepdims=True)
    return np.where(least[:, None] <= NOTHING, found, np.nan)


def backwards(flow: Flow, active: tuple[int, ...], c: NDArray[Any]) -> NDArray[np.bool_]:
    """Where conjugate amplitudes move backwards, and a symmetry moves them, shape (K,).

    Parameters
    ----------
    flow, active, c
        As for `conserved`.
    """
    place = chart(flow, active)
    own = c[:, list(place.columns)]
    imaginary = np.abs(own.real) <= NOTHING * np.abs(own)
    return np.asarray(imaginary.all(axis=1) & bool(place.drifts))


def selecting(
    flow: Flow,
    c: NDArray[Any],
    k: int,
    square: NDArray[np.float64],
    where: tuple[int, ...],
) -> tuple[Flow, NDArray[np.complex128]]:
    """The slow flow with the terms that ask for |B_k|² = ρ in the equations `where`.

    Parameters
    ----------
    flow : Flow
    c : numpy.ndarray
        Shape (K, terms).
    k : int
    square : numpy.ndarray
        ρ, shape (K,).
    where : tuple of int
    """
    size = 3 * flow.n
    plain = {j: tuple(int(i == 3 * j) for i in range(size)) for j in where}
    cubic = {j: tuple(x + (i in (3 * k, 3 * k + 1)) for i, x in enumerate(plain[j])) for j in where}
    added = {(j, e) for j in where for e in (plain[j], cubic[j])}
    terms = tuple(sorted({*flow.terms, *added}))
    degrees = np.array([sum(e) - 1.0 for _, e in flow.terms])
    # As fast as the terms of the flow are where all amplitudes are of that size.
    rate = (np.abs(c) * np.sqrt(square)[:, None] ** degrees).max(axis=1)
    out = np.zeros((len(c), len(terms)), dtype=np.complex128)
    for m, term in enumerate(flow.terms):
        out[:, terms.index(term)] = c[:, m]
    for j in where:
        out[:, terms.index((j, plain[j]))] += rate
        out[:, terms.index((j, cubic[j]))] -= rate / square
    return flow._replace(terms=terms), out
