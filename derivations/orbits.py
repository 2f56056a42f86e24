"""Periodic motions of exact equations, by Newton's method on the map over one period.

An independent witness for formulas of steady amplitudes: nothing here knows of expansions.
"""

import numpy as np

from mmsgen.motion import exact_motion, first_order_system

SAMPLES = 64
STEPS = 30
REACH = 0.1
"""Largest step over the size of the motion: near folds Newton's own ones lead astray."""


def orbit(eom, values, period, start):
    """The periodic motion near a starting state (q, q').

    Returns the states at `SAMPLES` equidistant times of the period, shape (2n, SAMPLES), and the
    multipliers of the motion: it is stable if all of them are inside the unit circle.
    """
    derivative = first_order_system(eom, values)
    times = np.linspace(0, period, SAMPLES + 1)
    state = np.array(start, dtype=float)
    scale = np.abs(state).max()
    shift = 1e-6 * scale
    for _ in range(STEPS):
        path = exact_motion(derivative, state, times, scale)
        ends = [
            exact_motion(derivative, state + shift * unit, times[[0, -1]], scale)[:, -1]
            for unit in np.eye(len(state))
        ]
        monodromy = (np.stack(ends, axis=1) - path[:, -1:]) / shift
        step = np.linalg.solve(np.eye(len(state)) - monodromy, path[:, -1] - state)
        state = state + step * min(1, REACH * scale / np.abs(step).max())
        if np.abs(step).max() < 1e-9 * scale:
            return path[:, :-1], np.linalg.eigvals(monodromy)
    raise ArithmeticError(f"no periodic motion near {start}")


def harmonic(samples, k):
    """The amplitude of the k-th harmonic of a motion sampled over one period."""
    return 2 * np.abs(np.fft.rfft(samples)[k]) / len(samples)
