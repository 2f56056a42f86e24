"""`Certificate`: fitted against theoretical exponents, as a record that can be read and written."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import CertificateError, UnresolvedError
from .tables import relation_text

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = ["Certificate", "Fit", "Zone", "fit_exponent", "supported", "title"]

TOLERANCE = 0.1
"""How far a fitted exponent may fall short of the theory's.

Neighbouring orders differ by 1. The fit allows for the next term of the error, whose neglected
successor shifts the exponent by less than 0.05 over the default range of ε.
"""

RESOLVED = 30.0
"""An error counts as resolved from this many times the reference's own error."""

SMALLEST = 1e-9
"""Errors below this one take no part unless said otherwise: a limit that no last bit moves."""

NONE = "none"
"""The relation of a case without any."""

NEEDED = 4
"""Points of a fit with three unknowns."""

TAKEN = 6
"""Points that a fit takes at most, those of the smallest ε.

An error in a coefficient of order p ≤ N is a term ε^p beside the ε^{N+1} that the order may leave,
and overtakes it only as ε → 0.
"""


def title(case: Expansion) -> str:
    """The resonance relations of a case as text, or ``"none"``."""
    texts = (relation_text(r.equation, case.parameters) for r in case.relations)
    return ", ".join(texts) or NONE


def supported(value: float, error: float, digits: int = 3) -> str:
    """A number in as many digits as its error estimate supports, and no more.

    Parameters
    ----------
    value : float
    error : float
        Estimated error of the value, absolute.
    digits : int
        Significant digits at most. Few ones keep a record the same on every machine, on which
        the last bits differ.

    Returns
    -------
    str
        Exponential notation; ``"nan"`` where there is no value, ``"0"`` where the error is larger.
    """
    if not math.isfinite(value):
        return "nan"
    if not abs(value) > error:
        return "0"
    # A quotient would overflow.
    spare = math.floor(math.log10(abs(value)) - math.log10(error)) - 1 if error else digits
    return f"{value:.{max(0, min(digits, spare) - 1)}e}"


@dataclass(frozen=True)
class Fit:
    """Errors over ε and the exponent fitted to them.

    Attributes
    ----------
    quantity : str
    theory : int
        The exponent that the order claims, at least.
    epsilons, errors, floors : tuple of float
        ε, error of the result in s⁻¹ or rad/s, and the error of the reference itself.
    exponent : float
        Fitted to the resolved errors of the smallest ε, log e = log C + p log ε + dε.
    limit : float
        Errors below this one take no part, whatever the floors.
    place : tuple of (str, float)
        Values at ε = 1 where they are not those of the certificate: of a steady motion.
    near : tuple of complex
        Amplitudes at ε = 1 near which that motion is.
    """

    quantity: str
    theory: int
    epsilons: tuple[float, ...]
    errors: tuple[float, ...]
    floors: tuple[float, ...]
    exponent: float
    limit: float = SMALLEST
    place: tuple[tuple[str, float], ...] = ()
    near: tuple[complex, ...] = ()

    @property
    def resolved(self) -> tuple[bool, ...]:
        """Which errors are well above that of the reference."""
        pairs = zip(self.errors, self.floors, strict=True)
        return tuple(math.isfinite(e) and e > max(RESOLVED * f, self.limit) for e, f in pairs)

    @property
    def passed(self) -> bool:
        """Whether the exponent is the theory's, or more where an error term vanishes."""
        return self.exponent > self.theory - TOLERANCE

    def as_dict(self) -> dict[str, Any]:
        """Plain data for JSON, the digits of errors set by the limit alone.

        The floors are estimates, of which the last bits differ between machines.
        """
        own: dict[str, Any] = {}
        if self.place:
            own["values"] = {name: repr(v) for name, v in self.place}
            own["amplitudes"] = [f"{b.real:g}{b.imag:+g}i" for b in self.near]
        return {
            "quantity": self.quantity,
            **own,
            "theory": self.theory,
            "fitted": f"{self.exponent:.2f}",
            "passed": self.passed,
            "points": [
                {"epsilon": e, "error": supported(x, self.limit / RESOLVED)}
                for e, x, ok in zip(self.epsilons, self.errors, self.resolved, strict=True)
                if ok
            ],
        }


def fit_exponent(
    quantity: str,
    theory: int,
    epsilons: Sequence[float],
    errors: Sequence[float],
    floors: Sequence[float],
    *,
    limit: float = SMALLEST,
) -> Fit:
    """Fit the exponent of an error that falls like ε^p (1 + O(ε)).

    Parameters
    ----------
    quantity : str
    theory : int
        The exponent that is claimed.
    epsilons, errors, floors : sequence of float
        ε, error, and error of the reference.
    limit : float
        Errors below this one take no part.

    Raises
    ------
    CertificateError
        If fewer than four errors are resolved.
    """
    fit = Fit(quantity, theory, tuple(epsilons), tuple(errors), tuple(floors), math.nan, limit)
    resolved = zip(fit.epsilons, fit.errors, fit.resolved, strict=True)
    points = sorted((e, x) for e, x, ok in resolved if ok)[:TAKEN]
    if len({e for e, _ in points}) < NEEDED:
        raise UnresolvedError(
            f"only {len(points)} of {len(errors)} errors of the {quantity} are above what the "
            "reference resolves: choose larger values of ε, or parameters that interact more"
        )
    e, x = np.array(points).T
    # In units of the largest ε the columns are of one size.
    design = np.stack([np.ones_like(e), np.log(e / e.max()), e / e.max()], axis=1)
    solution, *_ = np.linalg.lstsq(design, np.log(x), rcond=None)
    return replace(fit, exponent=float(solution[1]))


@dataclass(frozen=True)
class Zone:
    """A zone of instability at the user's numbers, ε = 1.

    Attributes
    ----------
    symbol, unit : str
        What is varied.
    emitted, exact : tuple of float
        Both edges, from the emitted function and from Floquet's.
    error : float
        Of Floquet's edges.
    """

    symbol: str
    unit: str
    emitted: tuple[float, float]
    exact: tuple[float, float]
    error: float

    def as_dict(self) -> dict[str, Any]:
        """Plain data for JSON."""
        return {
            "symbol": self.symbol,
            "unit": self.unit,
            "emitted": [supported(x, 1e-12 * abs(x), 8) for x in self.emitted],
            "floquet": [supported(x, self.error, 8) for x in self.exact],
        }


@dataclass(frozen=True)
class Certificate:
    """What was compared for one case, and whether it holds.

    Attributes
    ----------
    relation : str
        The resonance relations, or ``"none"``.
    order : int
    values : tuple of (str, float)
        The parameter values at ε = 1.
    fits : tuple of Fit
    zones : tuple of Zone
    """

    relation: str
    order: int
    values: tuple[tuple[str, float], ...]
    fits: tuple[Fit, ...]
    zones: tuple[Zone, ...] = ()

    @classmethod
    def of_case(
        cls,
        case: Expansion,
        values: Mapping[str, float],
        fits: tuple[Fit, ...],
        zones: tuple[Zone, ...] = (),
    ) -> Certificate:
        """Make the certificate of a case."""
        return cls(title(case), case.order, tuple(sorted(values.items())), fits, zones)

    @property
    def passed(self) -> bool:
        """Whether every fit has the theory's exponent."""
        return all(f.passed for f in self.fits)

    @property
    def failure(self) -> str:
        """Which fit fails and how; empty where none does."""
        case = "the case without resonance" if self.relation == NONE else self.relation
        return "; ".join(
            f"{f.quantity} of {case} at order {self.order}: the error falls like "
            f"ε^{f.exponent:.2f}, the theory demands ε^{f.theory}"
            for f in self.fits
            if not f.passed
        )

    def demand(self) -> None:
        """Raise unless the certificate holds.

        Raises
        ------
        CertificateError
            With what fails.
        """
        if not self.passed:
            raise CertificateError(self.failure)

    def to_json(self) -> str:
        """The certificate as JSON text; the same on every machine."""
        data = {
            "relation": self.relation,
            "order": self.order,
            "values": {name: repr(v) for name, v in self.values},
            "passed": self.passed,
            "fits": [f.as_dict() for f in self.fits],
            "zones": [z.as_dict() for z in self.zones],
        }
        return json.dumps(data, indent=2, ensure_ascii=False) + "\n"

    def __str__(self) -> str:
        lines = [f"{self.relation}, order {self.order}: {'holds' if self.passed else 'FAILS'}"]
        lines += [
            f"  {f.quantity}: error ~ ε^{f.exponent:.2f}, theory ε^{f.theory}" for f in self.fits
        ]
        lines += [
            f"  {z.symbol} {z.emitted[0]:.5f} … {z.emitted[1]:.5f} {z.unit}, Floquet "
            f"{z.exact[0]:.5f} … {z.exact[1]:.5f}"
            for z in self.zones
        ]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        return f"<pre>{escape(str(self))}</pre>"
