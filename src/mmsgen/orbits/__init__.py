"""Periodic orbits of the exact, unexpanded equations, with their multipliers.

Collocation on intervals, Newton's method, multipliers from the variational equations, and
continuation along a parameter through folds. Nothing here knows of small parameters, and no code
is shared with the expansion. Every number comes with an estimate of its error, every verdict is
stable, unstable or undecided.

Sources: Ascher, Mattheij & Russell, *Numerical Solution of Boundary Value Problems for Ordinary
Differential Equations* (1988); Seydel, *Practical Bifurcation and Stability Analysis* (1994);
Kuznetsov, *Elements of Applied Bifurcation Theory* (2004).
"""

from .crossings import crossing
from .fields import Autonomous, Problem, autonomous
from .finding import find, settle
from .folds import fold
from .following import Path, follow
from .hopf import born
from .mechanical import Mechanical, problem
from .records import PeriodicOrbit
from .specials import Special
from .tori import Torus, torus

__all__ = [
    "Autonomous",
    "Mechanical",
    "Path",
    "PeriodicOrbit",
    "Problem",
    "Special",
    "Torus",
    "autonomous",
    "born",
    "crossing",
    "find",
    "fold",
    "follow",
    "problem",
    "settle",
    "torus",
]
