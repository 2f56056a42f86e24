"""Periodic coefficients: finite Fourier series whose coefficients are parameters."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from .errors import ModelError
from .parameters import Parameter
from .validation import TIME

__all__ = ["FourierSeries", "fourier_series"]


@dataclass(frozen=True)
class FourierSeries:
    """A periodic function of time, as an expression and its parameters.

    Attributes
    ----------
    expression : sympy.Expr
        Σ c_n cos nΩt + s_n sin nΩt, to stand in a Lagrangian or in equations.
    parameters : tuple of Parameter
        c_1, s_1, c_2, s_2, …, for the parameters of the model.
    """

    expression: sp.Expr
    parameters: tuple[Parameter, ...]

    def orders(self, order: int = 1) -> dict[sp.Symbol, int]:
        """The same order in ε for every coefficient, for `EquationsOfMotion.scale`."""
        return {p.symbol: order for p in self.parameters}


def fourier_series(
    name: str,
    frequency: sp.Expr,
    harmonics: int,
    *,
    sines: bool = True,
    unit: str = "1",
    meaning: str = "",
) -> FourierSeries:
    """A periodic function without mean value: Σ_{n=1}^{N} c_n cos nΩt + s_n sin nΩt.

    Parameters
    ----------
    name : str
        The coefficients are called name_c1, name_s1, ….
    frequency : sympy.Expr
        Ω: a symbol, or a rational multiple of one, in rad/s.
    harmonics : int
        N ≥ 1.
    sines : bool
        Without them the function is even in time.
    unit, meaning : str
        Of the function.

    Returns
    -------
    FourierSeries

    Raises
    ------
    ModelError
        If `harmonics` is no whole number ≥ 1, or a name is no identifier.
    """
    if isinstance(harmonics, bool) or not isinstance(harmonics, int) or harmonics < 1:
        raise ModelError(
            f"a finite Fourier series has 1 or more harmonics, got {harmonics!r}; one that does "
            "not end has to be cut by you, and its remainder judged"
        )
    if not name.isidentifier():
        raise ModelError(f"{name!r} cannot begin the name of a coefficient: use an identifier")
    if not isinstance(frequency, sp.Expr) or not frequency.free_symbols:
        raise ModelError(
            f"the frequency of {name} must be an expression in a symbol: {frequency!r}"
        )
    if TIME in frequency.free_symbols:
        raise ModelError(f"the frequency of {name} depends on time: {frequency}")
    terms, parameters = [], []
    about = meaning or name
    for n in range(1, harmonics + 1):
        waves = [("c", sp.cos, "cosine"), ("s", sp.sin, "sine")][: 2 if sines else 1]
        for letter, wave, word in waves:
            symbol = sp.Symbol(f"{name}_{letter}{n}", real=True)
            parameters.append(Parameter(symbol, unit, f"{word} coefficient {n} of {about}"))
            terms.append(symbol * wave(n * frequency * TIME))
    return FourierSeries(sp.Add(*terms), tuple(parameters))
