"""Floquet theory of the exact linear equations M(t)q'' + C(t)q' + K(t)q = f(t).

Monodromy matrices of many parameter points at once by Gauss-Legendre collocation with node
accelerations as the unknowns (order 2s, s = 12 stages), from which follow multipliers, exponents,
growth rates, charts and boundaries. The equations are those of the model, unexpanded: nothing
here knows of small parameters, and no code is shared with the expansion. Every number comes
with an estimate of its error, every verdict is stable, unstable or undecided.

Sources: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, and Hairer &
Wanner, *… II* (collocation); Nayfeh & Mook, *Nonlinear Oscillations* (1979), ch. 5 (Floquet theory,
characteristic exponents); Stewart & Sun, *Matrix Perturbation Theory* (1990) (error bounds).
"""

from .charts import Chart, chart
from .edges import Boundary, boundary
from .exponents import exponents, growth_rate, monodromy, multipliers
from .records import Exponents, GrowthRate, Monodromy, Multipliers, Verdict

__all__ = [
    "Boundary",
    "Chart",
    "Exponents",
    "GrowthRate",
    "Monodromy",
    "Multipliers",
    "Verdict",
    "boundary",
    "chart",
    "exponents",
    "growth_rate",
    "monodromy",
    "multipliers",
]
