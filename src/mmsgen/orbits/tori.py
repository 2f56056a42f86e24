"""`torus`: quasi-periodic motions of an excited system, as closed curves of its stroboscopic map.

Seen once in every period T of the excitation, a motion with a second frequency ω lies on a closed
curve K(θ), along which it goes by the angle ρ = ωT each time: P(K(θ)) = K(θ + ρ), P being the map
over one period. K is a trigonometric polynomial through m points, ρ an unknown, and a step of
Newton's method has no part along the curve. Attracting and repelling curves are found alike. The
error falls faster than every power of 1/m.

Source: Schilder, Osinga & Vogt, *SIAM J. Appl. Dyn. Syst.* 4 (2005) 459 (invariant curves by
Fourier series).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
import scipy  # loads its subpackages when they are first used

from ..errors import OrbitError
from ..floquet.points import Floats
from .fields import Problem

__all__ = ["Torus", "torus"]

STEPS = 15
"""Newton steps at most; five are usual."""

LARGEST = 300
"""Points of the curve at most."""

RTOL = 1e-13
"""Tolerance of the integrations over a period."""

NOISE = 1e-11
"""A step that is this small, over the size of the curve, is rounding and integration."""

REACH = 0.5
"""Largest step, over the size of the curve."""


@dataclass(frozen=True, eq=False)
class Torus:
    """A quasi-periodic motion of an excited system.

    Attributes
    ----------
    frequency : float
        ω in rad/s, modulo the frequency of the excitation over `periods`.
    states : numpy.ndarray, shape (d, m)
        At phase 0 of the excitation and m equidistant phases of the second oscillation, m odd.
    error : float
        Difference of `states` from those of a coarser curve.
    frequency_error : float
        Likewise, of the frequency.
    problem : Problem
    periods : int
        Of the excitation, after which the motion is looked at.
    """

    frequency: float
    states: Floats
    error: float
    frequency_error: float
    problem: Problem = field(repr=False)
    periods: int = 1

    def lines(self, count: int) -> Floats:
        """Sizes of the first Fourier coefficients of the curve, |c_0|, |c_1|, …: (d, count)."""
        series = np.fft.rfft(self.states, axis=1)[:, :count]
        return np.asarray(np.abs(series) / self.states.shape[1])


def torus(
    problem: Problem,
    guess: Any,
    frequency: float,
    *,
    periods: int = 1,
    tolerance: float = 1e-9,
) -> Torus:
    """Find the quasi-periodic motion near a guess.

    Parameters
    ----------
    problem : Problem
        With an excitation.
    guess : array_like, shape (d, m)
        States at phase 0 of the excitation, at m equidistant phases of the second oscillation, m
        odd.
    frequency : float
        Of the second oscillation in rad/s, roughly.
    periods : int
        Periods of the excitation after which the motion is looked at.
    tolerance : float
        Difference of two curves, over their size, from which the finer one is taken.

    Returns
    -------
    Torus

    Raises
    ------
    OrbitError
        If there is no excitation, or none is found.
    """
    if problem.base is None:
        raise OrbitError("a torus is sought of a system with an excitation")
    states = np.asarray(guess, dtype=float)
    if states.ndim != 2 or len(states) != problem.size or not states.shape[1] % 2:
        raise OrbitError(f"the guess must have the shape ({problem.size}, m), m odd")
    if not np.isfinite(states).all():
        raise OrbitError("the guess must be finite: it holds NaN or infinity")
    period = 2 * np.pi * periods / problem.base
    curve, angle = _newton(problem, states.T, frequency * period, period, periods)
    while True:
        finer = _on(curve, 2 * len(curve) + 1)
        fine, turn = _newton(problem, finer, angle, period, periods)
        gap, slip = float(np.abs(fine - finer).max()), abs(turn - angle)
        done = max(gap / float(np.abs(fine).max()), slip) <= tolerance
        if done or 2 * len(fine) > LARGEST:
            return Torus(turn / period, fine.T, gap, slip / period, problem, periods)
        curve, angle = fine, turn


def _newton(
    problem: Problem, curve: Floats, angle: float, period: float, periods: int
) -> tuple[Floats, float]:
    """Newton's method for the points (m, d) and the angle."""
    m, d = curve.shape
    along = _turned(m, 0.0)[1] @ curve
    scale = float(np.abs(curve - curve.mean(axis=0)).max())
    if not scale > 0:
        raise OrbitError("the guess of a torus is a point: give the curve")
    for _ in range(STEPS):
        ahead, maps = _strobed(problem, curve, period, periods)
        shift, slope = _turned(m, angle)
        matrix = np.zeros((m * d + 1, m * d + 1))
        blocks = matrix[:-1, :-1].reshape(m, d, m, d)
        blocks[range(m), :, range(m), :] = maps
        blocks -= np.einsum("ij,kl->ikjl", shift, np.eye(d))
        matrix[:-1, -1] = -(slope @ curve).ravel()
        matrix[-1, :-1] = along.ravel() / scale
        right = np.append((shift @ curve - ahead).ravel(), 0.0)
        try:
            step = np.linalg.solve(matrix, right)
        except np.linalg.LinAlgError:
            raise OrbitError("the equations of the torus are singular") from None
        size = float(np.abs(step[:-1]).max()) / scale
        if not np.isfinite(size):
            break
        share = min(1.0, REACH / size) if size > 0 else 1.0
        curve = curve + share * step[:-1].reshape(m, d)
        angle += share * float(step[-1])
        if size < NOISE:
            return curve, angle
    raise OrbitError("no torus is found near the guess: Newton's method does not converge")


def _turned(m: int, angle: float) -> tuple[Floats, Floats]:
    """Matrices that give a trigonometric polynomial and its slope, at points turned by an angle."""
    apart = 2 * np.pi / m * np.subtract.outer(np.arange(m), np.arange(m)) + angle
    numbers = np.arange(1, m // 2 + 1)
    waves = np.multiply.outer(apart, numbers)
    values = (1 + 2 * np.cos(waves).sum(axis=-1)) / m
    slopes = -2 * (numbers * np.sin(waves)).sum(axis=-1) / m
    return np.asarray(values), np.asarray(slopes)


def _on(curve: Floats, count: int) -> Floats:
    """The same curve at another odd number of points."""
    m = len(curve)
    series = np.zeros((count // 2 + 1, curve.shape[1]), dtype=complex)
    series[: m // 2 + 1] = np.fft.rfft(curve, axis=0) * (count / m)
    return np.asarray(np.fft.irfft(series, count, axis=0))


def _strobed(problem: Problem, curve: Floats, period: float, periods: int) -> tuple[Floats, Floats]:
    """Where the points are after the period, (m, d), and the derivatives of that, (m, d, d)."""
    m, d = curve.shape
    rate = 2 * np.pi * periods / period

    def derivative(t: float, packed: Floats) -> Floats:
        y = packed.reshape(m, d, d + 1)
        rates, jacobians = problem.rates(np.full(m, rate * t), y[:, :, 0].T)
        return np.concatenate([rates[:, :, None], jacobians @ y[:, :, 1:]], axis=2).ravel()

    start = np.concatenate([curve[:, :, None], np.broadcast_to(np.eye(d), (m, d, d))], axis=2)
    size = float(np.abs(curve).max())
    found = scipy.integrate.solve_ivp(
        derivative, (0.0, period), start.ravel(), "DOP853", [period], rtol=RTOL, atol=RTOL * size
    )
    if not found.success:
        raise OrbitError(f"the equations cannot be integrated: {found.message}")
    end = found.y[:, -1].reshape(m, d, d + 1)
    return end[:, :, 0], end[:, :, 1:]
