"""Initial-value problems at any times, before and after the start, in any order."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import scipy  # loads its subpackages when they are first used

__all__ = ["RunAway", "solution_at"]


class RunAway(Exception):
    """The motion cannot be followed to a time.

    Attributes
    ----------
    time : float
    reason : str
    """

    def __init__(self, time: float, reason: str) -> None:
        super().__init__(reason)
        self.time, self.reason = time, reason


def solution_at(
    derivative: Callable[[float, Any], Any], start: Any, times: Any, rtol: float, atol: float
) -> Any:
    """States at times from that at t = 0, by the method of Dormand and Prince of order 8.

    Parameters
    ----------
    derivative : callable
        t, x → dx/dt.
    start : numpy.ndarray, shape (d,)
    times : numpy.ndarray
        Of any shape and sign.
    rtol, atol : float
        Local errors allowed.

    Returns
    -------
    numpy.ndarray
        Shape (*times.shape, d), of the type of `start`.

    Raises
    ------
    RunAway
        If the state leaves the numbers, or steps have to be too short.
    """
    flat = np.ravel(times)
    found = np.repeat(start[None], flat.size, axis=0)
    for sign in (1.0, -1.0):
        way = sign * flat > 0.0
        if not way.any():
            continue
        ahead, place = np.unique(np.abs(flat[way]), return_inverse=True)
        last = sign * float(ahead[-1])
        try:
            with np.errstate(all="ignore"):
                solution = scipy.integrate.solve_ivp(
                    derivative, (0.0, last), start, "DOP853", sign * ahead, rtol=rtol, atol=atol
                )
        except (ArithmeticError, ValueError) as error:  # as plain numbers say infinity and NaN
            raise RunAway(last, str(error)) from error
        if not solution.success or not np.isfinite(solution.y).all():
            raise RunAway(last, str(solution.message))
        found[way] = solution.y.T[place]
    return found.reshape(*np.shape(times), len(start))
