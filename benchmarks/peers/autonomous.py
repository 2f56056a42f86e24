"""The equations of the examples of asymptotics: one coordinate, u(0) = 1, u'(0) = 0."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Autonomous:
    """u'' + ω²u + ε(cubic u³ + damping u' + pumping u²u') = 0.

    Attributes
    ----------
    text : str
        The equation as asymptotics reads it.
    order : int
        Highest power of ε.
    square : int
        ω².
    cubic, damping, pumping : int
        Coefficients.
    strained : bool
        The frequency by Lindstedt and Poincaré's method, not the slow flow.
    """

    text: str
    order: int = 1
    square: int = 1
    cubic: int = 0
    damping: int = 0
    pumping: int = 0
    strained: bool = False


EXAMPLES = {
    "damped": Autonomous("u'' + u + eps*u'", damping=1),
    "damped_at_two": Autonomous("u'' + 4*u + eps*u'", square=4, damping=1),
    "cubic": Autonomous("u'' + u + eps*u**3", cubic=1),
    "limit_cycle": Autonomous("u'' + u + eps*(u**2 - 1)*u'", damping=-1, pumping=1),
    "strained_cubic": Autonomous("u'' + u + eps*u**3", order=2, cubic=1, strained=True),
    "strained_cubic_at_two": Autonomous("u'' + 4*u + eps*u**3", square=4, cubic=1, strained=True),
}
