"""Records of what a nonlinear slow flow answers: equilibria, branches, bifurcations, responses.

An equilibrium is a point B_j e^{i k_j ρ t}: the flow's symmetries k move it along its own copies,
each at a rate of its own ρ, rad/s, its *drift*. Where there is no symmetry it is at rest.
Phases are normalised by the symmetries: along each of them the first amplitude that is not zero
and that the symmetries before have left free is real and positive.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Backbone", "Bifurcation", "Branch", "Equilibria", "Response"]


class Equilibria(NamedTuple):
    """All equilibria of a slow flow, for each point of a batch of parameters.

    Attributes
    ----------
    amplitudes : numpy.ndarray
        Complex B_j, shape (..., k, n), for a motion a_j = 2|B_j|. The k equilibria of a point
        are in increasing order of Σ|B_j|², then of the phases in [0, 2π), those of the first
        coordinate first; the points that have fewer than k are filled up with NaN at the end.
    drift : numpy.ndarray
        Shape (..., k, g): ρ in rad/s for each of the g symmetries.
    growth : numpy.ndarray
        Shape (..., k): the largest real part of the Jacobian's eigenvalues, 1/s, where those that
        a symmetry makes zero are left out.
    """

    amplitudes: NDArray[np.complex128]
    drift: NDArray[np.float64]
    growth: NDArray[np.float64]

    @property
    def modulus(self) -> NDArray[np.float64]:
        """Real amplitudes a_j = 2|B_j|, shape (..., k, n)."""
        return 2.0 * np.abs(self.amplitudes)

    @property
    def stable(self) -> NDArray[np.bool_]:
        """Where all disturbances die out, shape (..., k); False where there is no equilibrium."""
        return self.growth < 0.0

    @property
    def number(self) -> NDArray[np.int64]:
        """How many equilibria each point has."""
        return np.isfinite(self.amplitudes).all(axis=-1).sum(axis=-1)


class Backbone(NamedTuple):
    """Free motions without damping in which one amplitude is given.

    Attributes
    ----------
    amplitudes : numpy.ndarray
        Complex B_j, shape (..., k, n): the k motions of a point in the order of `Equilibria`, NaN
        after the last one.
    shift : numpy.ndarray
        Shape (..., k, n), rad/s: by how much the frequency of each coordinate is off the natural
        one; where a resonance replaces that, as ω_2 = 2ω_1 + σ, off what it is at σ = 0. NaN where
        an amplitude is zero.
    detuning : numpy.ndarray
        Shape (..., k), rad/s: the detuning of a force that acts at that frequency, where the
        backbone is in a response over this detuning. NaN where the slow flow has no such force.
    growth : numpy.ndarray
        Shape (..., k): the largest real part of the Jacobian's eigenvalues, 1/s, without the two
        zeros that the phase and the amplitude of a free motion have. Zero where disturbances
        neither grow nor die out.
    """

    amplitudes: NDArray[np.complex128]
    shift: NDArray[np.float64]
    detuning: NDArray[np.float64]
    growth: NDArray[np.float64]

    @property
    def modulus(self) -> NDArray[np.float64]:
        """Real amplitudes a_j = 2|B_j|, shape (..., k, n)."""
        return 2.0 * np.abs(self.amplitudes)

    @property
    def stable(self) -> NDArray[np.bool_]:
        """Where disturbances do not grow, shape (..., k); False where there is no motion."""
        return self.growth <= 0.0

    @property
    def number(self) -> NDArray[np.int64]:
        """How many motions each point has."""
        return np.isfinite(self.amplitudes).all(axis=-1).sum(axis=-1)


class Branch(NamedTuple):
    """A curve of equilibria, its points in order along the curve.

    Attributes
    ----------
    parameter : numpy.ndarray
        Shape (m,): values of the parameter that varies.
    amplitudes : numpy.ndarray
        Complex, shape (m, n).
    drift : numpy.ndarray
        Shape (m, g), rad/s.
    growth : numpy.ndarray
        Shape (m,), 1/s: as in `Equilibria`.
    """

    parameter: NDArray[np.float64]
    amplitudes: NDArray[np.complex128]
    drift: NDArray[np.float64]
    growth: NDArray[np.float64]

    @property
    def modulus(self) -> NDArray[np.float64]:
        """Real amplitudes a_j = 2|B_j|, shape (m, n)."""
        return 2.0 * np.abs(self.amplitudes)

    @property
    def stable(self) -> NDArray[np.bool_]:
        """Where all disturbances die out, shape (m,)."""
        return self.growth < 0.0


class Bifurcation(NamedTuple):
    """A point at which equilibria meet, or change their stability.

    Attributes
    ----------
    kind : str
        "saddle-node", "pitchfork", "transcritical" or "Hopf".
    parameter : float
        Value of the parameter that varies.
    amplitudes : numpy.ndarray
        Complex, shape (n,).
    drift : numpy.ndarray
        Shape (g,), rad/s.
    frequency : float
        Of the oscillation that a Hopf point gives birth to, rad/s; zero for the other kinds.
    """

    kind: str
    parameter: float
    amplitudes: NDArray[np.complex128]
    drift: NDArray[np.float64]
    frequency: float

    @property
    def modulus(self) -> NDArray[np.float64]:
        """Real amplitudes a_j = 2|B_j|, shape (n,)."""
        return 2.0 * np.abs(self.amplitudes)


class Response(NamedTuple):
    """Equilibria along one parameter.

    Attributes
    ----------
    name : str
        Of the parameter that varies.
    branches : tuple of Branch
    bifurcations : tuple of Bifurcation
        In increasing order of the parameter.
    """

    name: str
    branches: tuple[Branch, ...]
    bifurcations: tuple[Bifurcation, ...]
