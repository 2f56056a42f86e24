"""Many motions of exact equations at once, and the amplitudes of their oscillations.

A witness for steady states that are not periodic: nothing here knows of expansions.
"""

import numpy as np
import sympy as sp
from scipy.integrate import solve_ivp


def accelerations(eom, values):
    """The function t, q, q' → q'' for arrays q, q' of shape (n, motions).

    Parameters
    ----------
    eom : EquationsOfMotion
    values : mapping
        Name → number, or an array with one number for each motion.
    """
    n, t = len(eom.coordinates), eom.time
    state = [[sp.Dummy() for _ in range(n)] for _ in range(3)]
    place = {
        (q.diff(t, k) if k else q): s
        for k in (2, 1, 0)
        for q, s in zip(eom.coordinates, state[k], strict=True)
    }
    plain = [e.subs(place) for e in eom.equations]
    mass = sp.Matrix(plain).jacobian(state[2])
    rest = [e.subs(dict.fromkeys(state[2], 0)) for e in plain]
    symbols = [p.symbol for p in eom.parameters if p.name in values]
    numbers = [np.asarray(values[str(s)], dtype=float) for s in symbols]
    entries = [((i, j), mass[i, j]) for i in range(n) for j in range(n) if mass[i, j] != 0]
    arguments = [t, *state[0], *state[1], *symbols]
    function = sp.lambdify(arguments, [*rest, *(e for _, e in entries)], "numpy", cse=True)

    def acceleration(time, q, v):
        found = function(time, *q, *v, *numbers)
        force = np.stack(np.broadcast_arrays(*found[:n], q[0])[:n], axis=-1)
        matrix = np.zeros((*force.shape, n))
        for ((i, j), _), entry in zip(entries, found[n:], strict=True):
            matrix[..., i, j] = entry
        return -np.linalg.solve(matrix, force[..., None])[..., 0].T

    return acceleration


def integrate(eom, values, start, times, tolerance=1e-8):
    """States at times, shape (2n, motions, times), from states (2n, motions) at times[0]."""
    acceleration = accelerations(eom, values)
    shape = start.shape
    n = shape[0] // 2

    def derivative(time, flat):
        state = flat.reshape(shape)
        return np.concatenate([state[n:], acceleration(time, state[:n], state[n:])]).ravel()

    solution = solve_ivp(
        derivative,
        (times[0], times[-1]),
        start.ravel(),
        "DOP853",
        times,
        rtol=tolerance,
        atol=tolerance * np.abs(start).max(),
    )
    assert solution.success, solution.message
    return solution.y.reshape(*shape, -1)


def fundamental(times, signals, frequency, reach):
    """Amplitude and frequency of the strongest oscillation within reach of a frequency.

    The mean of e^{−iνt} times the signal, under a window of the form cos⁴, is largest at ν. What
    stands m of the resolutions 2π/span away leaks by less than 2/m⁵.

    Parameters
    ----------
    times : array, shape (m,)
        Equidistant.
    signals : array, shape (..., m)
    frequency, reach : float
        In rad/s.
    """
    span = times[-1] - times[0]
    window = np.cos(np.pi * ((times - times[0]) / span - 0.5)) ** 4
    weighted = np.asarray(signals) * (window / window.sum())

    def size(nu):
        return 2 * np.abs((np.exp(-1j * nu[..., None] * times) * weighted).sum(axis=-1))

    grid = np.arange(frequency - reach, frequency + reach, np.pi / span / 4)
    nu = grid[np.argmax([size(np.full(weighted.shape[:-1], g)) for g in grid], axis=0)]
    step = np.pi / span / 4
    for _ in range(4):  # parabolas through the top: each leaves a small part of the distance
        left, top, right = (size(nu + k * step) for k in (-1, 0, 1))
        bend = np.minimum(left - 2 * top + right, -1e-3 * top)
        nu = nu + step * np.clip((left - right) / (2 * bend), -1, 1)
        step /= 4
    return size(nu), nu
