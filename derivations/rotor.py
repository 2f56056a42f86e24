"""Helicopter ground resonance: the model, and the steps from its parameters to ratios.

A fuselage on springs and dampers (x, y) carries a rotor of N_b blades that turns at Ω. Blade k
stands at azimuth ζ_k = Ωt + 2π(k−1)/N_b. Its hinge is at eccentricity a, its centre of gravity
lies b further out, and it lags by φ_k:

    x_k = x + a cos ζ_k + b cos(ζ_k + φ_k),    y_k = y + a sin ζ_k + b sin(ζ_k + φ_k).

The steps, each of which is a plain function that returns new equations:

    model     = helicopter(N_b)               every blade with its own m, I, K_b, c_b
    eom       = model.equations_of_motion()   nonlinear, nothing neglected
    isotropic(eom)                            all blades alike
    in_ratios(eom)                            r_m, r_b, r_a, ω_x, ω_y, ω_b and damping rates
    at_speed(eom)                             ω_b replaced by the lag frequency at speed, ω_φ

and `eom.linearise()`, which may stand anywhere between them. `with_nonlinear_hinges(model)` gives
the blades springs and dampers that are not linear; `unlike_masses(eom)` in place of `isotropic`
lets their masses differ.

Source: Sanches, Michon, Berlioz and Alazard, "Response and instability prediction of helicopter
dynamics on the ground", Int. J. Non-Linear Mechanics (2014), doi 10.1016/j.ijnonlinmec.2014.04.003.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp
from sympy.physics.mechanics import dynamicsymbols

from mmsgen.equations import EquationsOfMotion
from mmsgen.errors import ModelError
from mmsgen.model import Model
from mmsgen.parameters import Parameter

__all__ = [
    "PAPER_VALUES",
    "at_speed",
    "helicopter",
    "in_ratios",
    "isotropic",
    "paper_values",
    "undamped",
    "unlike_masses",
    "with_nonlinear_hinges",
]


def _positive(symbol_names: str) -> tuple[sp.Symbol, ...]:
    return tuple(sp.symbols(symbol_names, positive=True, seq=True))


def _nonnegative(symbol_names: str) -> tuple[sp.Symbol, ...]:
    return tuple(sp.symbols(symbol_names, nonnegative=True, seq=True))


time = dynamicsymbols._t
Omega, a, b, m_f, K_x, K_y = _positive("Omega a b m_f K_x K_y")
m, inertia, K_b = _positive("m I K_b")
c_x, c_y, c_b = _nonnegative("c_x c_y c_b")
K_3 = sp.Symbol("K_3", real=True)
c_2, c_3 = _nonnegative("c_2 c_3")
r_m, r_b, r_a, r_h = _positive("r_m r_b r_a r_h")
omega_x, omega_y, omega_b, omega_phi = _positive("omega_x omega_y omega_b omega_phi")
mu_x, mu_y, mu_b, mu_2, mu_3 = _nonnegative("mu_x mu_y mu_b mu_2 mu_3")
kappa = sp.Symbol("kappa", real=True)

_ROTOR = [
    Parameter(Omega, "rad/s", "rotor speed"),
    Parameter(a, "m", "eccentricity of the lag hinges"),
    Parameter(b, "m", "distance from a lag hinge to its blade's centre of gravity"),
]
_FUSELAGE = [
    Parameter(m_f, "kg", "mass of the fuselage"),
    Parameter(K_x, "N/m", "longitudinal stiffness under the fuselage"),
    Parameter(K_y, "N/m", "lateral stiffness under the fuselage"),
    Parameter(c_x, "N s/m", "longitudinal damping of the fuselage"),
    Parameter(c_y, "N s/m", "lateral damping of the fuselage"),
]
_BLADE = [
    Parameter(m, "kg", "mass of a blade"),
    Parameter(inertia, "kg m^2", "inertia of a blade about its centre of gravity"),
    Parameter(K_b, "N m/rad", "lag stiffness of a blade"),
    Parameter(c_b, "N m s/rad", "lag damping of a blade"),
]
_HINGE = [
    Parameter(K_3, "N m/rad^3", "cubic lag stiffness of a blade"),
    Parameter(c_2, "N m s^2/rad^2", "lag damping of a blade by the square of its velocity"),
    Parameter(c_3, "N m s^3/rad^3", "lag damping of a blade by the cube of its velocity"),
]


def _of_blade(parameter: Parameter, k: int) -> Parameter:
    """The parameter of blade k: m_1, I_1, K_b1, c_b1."""
    name = f"{parameter.name}{k}" if "_" in parameter.name else f"{parameter.name}_{k}"
    (symbol,) = _positive(name) if parameter.symbol.is_positive else _nonnegative(name)
    return Parameter(symbol, parameter.unit, parameter.meaning.replace("a blade", f"blade {k}"))


def azimuth(k: int, N_b: int) -> sp.Expr:
    """ζ_k = Ωt + 2π(k−1)/N_b, the azimuth of blade k = 1 … N_b."""
    return Omega * time + 2 * sp.pi * sp.Rational(k - 1, N_b)


def helicopter(N_b: int = 4) -> Model:
    """Build the nonlinear model of a fuselage and N_b blades that all may differ.

    Parameters
    ----------
    N_b : int
        Number of blades, at least 2.

    Returns
    -------
    Model
        Coordinates x, y, phi_1 … phi_N; parameters of the rotor, the fuselage and each blade.

    Raises
    ------
    ModelError
        If N_b is not an integer of at least 2.
    """
    if isinstance(N_b, bool) or not isinstance(N_b, int) or N_b < 2:
        raise ModelError(f"a rotor needs an integer number of blades N_b >= 2, got {N_b!r}")
    x, y = dynamicsymbols("x y")
    blades = range(1, N_b + 1)
    phi = [dynamicsymbols(f"phi_{k}") for k in blades]
    parameters = [*_ROTOR, *_FUSELAGE]

    kinetic = m_f * (x.diff(time) ** 2 + y.diff(time) ** 2) / 2
    potential = (K_x * x**2 + K_y * y**2) / 2
    dissipation = (c_x * x.diff(time) ** 2 + c_y * y.diff(time) ** 2) / 2
    for k in blades:
        own = [_of_blade(parameter, k) for parameter in _BLADE]
        m_k, I_k, K_k, c_k = (parameter.symbol for parameter in own)
        zeta, phi_k = azimuth(k, N_b), phi[k - 1]
        x_k = x + a * sp.cos(zeta) + b * sp.cos(zeta + phi_k)
        y_k = y + a * sp.sin(zeta) + b * sp.sin(zeta + phi_k)
        kinetic += m_k * (x_k.diff(time) ** 2 + y_k.diff(time) ** 2) / 2
        kinetic += I_k * (zeta + phi_k).diff(time) ** 2 / 2
        potential += K_k * phi_k**2 / 2
        dissipation += c_k * phi_k.diff(time) ** 2 / 2
        parameters += own
    return Model(kinetic - potential, [x, y, *phi], parameters, dissipation=dissipation)


def with_nonlinear_hinges(model: Model) -> Model:
    """Add the moments K_3 φ³ + c_2 φ'|φ'| + c_3 φ'³ to the hinges of all blades.

    Elastomeric dampers stiffen, or soften, and damp more as they move more; a hydraulic one, whose
    oil passes an orifice, resists by the square of the velocity.

    Parameters
    ----------
    model : Model
        Of `helicopter`.
    """
    forces = {}
    for phi_k in model.coordinates[2:]:
        speed = phi_k.diff(time)
        forces[phi_k] = -(K_3 * phi_k**3 + c_2 * speed * sp.Abs(speed) + c_3 * speed**3)
    parameters = [*model.parameters, *_HINGE]
    return replace(model, parameters=parameters, forces=forces)


def isotropic(eom: EquationsOfMotion, own_stiffness: bool = False) -> EquationsOfMotion:
    """Make all blades alike: m_k = m, I_k = I, K_bk = K_b, c_bk = c_b.

    Parameters
    ----------
    eom : EquationsOfMotion
        Of `helicopter`, linear or not.
    own_stiffness : bool
        Leave every blade its own lag stiffness K_bk, for a rotor with one different blade.
    """
    shared = [p for p in _BLADE if not (own_stiffness and p.symbol == K_b)]
    mapping = {
        _of_blade(parameter, k).symbol: parameter.symbol
        for parameter in shared
        for k in range(1, _number_of_blades(eom) + 1)
    }
    return eom.reparametrise(_only_known(mapping, eom), shared)


def unlike_masses(eom: EquationsOfMotion) -> EquationsOfMotion:
    """Make all blades alike but for their masses, m_k = m(1 + e_k) and I_k = I(1 + e_k).

    Lag springs and dampers are the same, so that a heavier blade is slower as well.
    """
    blades = range(1, _number_of_blades(eom) + 1)
    shares = {k: sp.Symbol(f"e_{k}", real=True) for k in blades}
    mapping = {}
    for parameter in _BLADE:
        for k, share in shares.items():
            factor = 1 + share if parameter.symbol in (m, inertia) else 1
            mapping[_of_blade(parameter, k).symbol] = factor * parameter.symbol
    parameters = [
        Parameter(share, "1", f"what blade {k} is heavier by, over the mass of a blade")
        for k, share in shares.items()
    ]
    return eom.reparametrise(_only_known(mapping, eom), [*_BLADE, *parameters])


def undamped(eom: EquationsOfMotion) -> EquationsOfMotion:
    """Take out every damper that the equations have."""
    dampers = [p.symbol for p in eom.parameters if p.name.startswith(("c_", "mu_"))]
    return eom.reparametrise(dict.fromkeys(dampers, sp.S.Zero))


def in_ratios(eom: EquationsOfMotion) -> EquationsOfMotion:
    """Write the equations of alike blades in ratios, frequencies and damping rates.

    With M the mass of it all and J = I + m b²: r_m = m b/M, r_b = m b/J, r_a² = a r_b, ω_x² =
    K_x/M, ω_y² = K_y/M, ω_b² = K_b/J, 2μ_x = c_x/M, 2μ_y = c_y/M, 2μ_b = c_b/J, κ = K_3/J, μ_2 =
    c_2/J, μ_3 = c_3/J. Solved for the old parameters, these leave m and b as units of mass and
    length, which must cancel: it is checked. Where blades differ in mass, b stands in r_h = a/b.
    """
    N_b = _number_of_blades(eom)
    M, J = m * b / r_m, m * b / r_b
    shares = [p.symbol for p in eom.parameters if p.name.startswith("e_")]
    mapping = {
        m_f: M - m * (N_b + sp.Add(*shares)),
        inertia: J - m * b**2,
        a: r_a**2 / r_b,
        K_x: M * omega_x**2,
        K_y: M * omega_y**2,
        c_x: 2 * M * mu_x,
        c_y: 2 * M * mu_y,
        c_b: 2 * J * mu_b,
        K_b: J * omega_b**2,
        K_3: J * kappa,
        c_2: J * mu_2,
        c_3: J * mu_3,
    }
    parameters = [
        Parameter(r_m, "m", "static moment of a blade over the mass of the helicopter"),
        Parameter(r_b, "1/m", "static moment of a blade over its inertia about the hinge"),
        Parameter(r_a, "1", "lag frequency per rotor speed of a blade without lag spring"),
        Parameter(omega_x, "rad/s", "longitudinal frequency of the fuselage"),
        Parameter(omega_y, "rad/s", "lateral frequency of the fuselage"),
        Parameter(mu_x, "1/s", "longitudinal damping rate of the fuselage"),
        Parameter(mu_y, "1/s", "lateral damping rate of the fuselage"),
        Parameter(mu_b, "1/s", "lag damping rate of a blade"),
        Parameter(omega_b, "rad/s", "lag frequency of a blade at rest"),
        Parameter(kappa, "1/s^2", "cubic lag stiffness of a blade over its inertia"),
        Parameter(mu_2, "1", "lag damping by the square of the velocity over the inertia"),
        Parameter(mu_3, "s", "lag damping by the cube of the velocity over the inertia"),
    ]
    for k in range(1, N_b + 1):
        frequency = _of_blade(parameters[8], k)
        mapping[_of_blade(_BLADE[2], k).symbol] = J * frequency.symbol**2
        parameters.append(frequency)
    if not shares:
        return eom.reparametrise(_only_known(mapping, eom), parameters, eliminate=[m, b])
    ratio = Parameter(r_h, "1", "eccentricity of a hinge over the distance from it to the centre")
    with_length = eom.reparametrise(_only_known(mapping, eom), parameters, eliminate=[m])
    return with_length.reparametrise({b: r_a**2 / (r_h * r_b)}, [ratio])


def at_speed(eom: EquationsOfMotion) -> EquationsOfMotion:
    """Replace ω_b by the lag frequency at speed, ω_φ = √(ω_b² + r_a² Ω²).

    The frequency is a symbol of its own, of which the definition stays known, so that it can be
    held fixed in an expansion although it depends on the rotor speed. Blades with frequencies of
    their own get ω_φ1 … ω_φN.
    """
    lag = Parameter(omega_phi, "rad/s", "lag frequency of a blade at speed")
    at_rest = Parameter(omega_b)
    blades = range(1, _number_of_blades(eom) + 1)
    pairs = [(at_rest, lag), *((_of_blade(at_rest, k), _of_blade(lag, k)) for k in blades)]
    known = {p.symbol for p in eom.parameters}
    mapping, parameters = {}, []
    for still, turning in pairs:
        if still.symbol in known:
            mapping[still.symbol] = sp.sqrt(turning.symbol**2 - r_a**2 * Omega**2)
            definition = sp.sqrt(still.symbol**2 + r_a**2 * Omega**2)
            parameters.append(Parameter(turning.symbol, turning.unit, turning.meaning, definition))
    return eom.reparametrise(mapping, parameters)


def _number_of_blades(eom: EquationsOfMotion) -> int:
    return len(eom.coordinates) - 2


def _only_known(
    mapping: Mapping[sp.Symbol, sp.Expr], eom: EquationsOfMotion
) -> dict[sp.Symbol, sp.Expr]:
    """The entries whose old parameter the equations have: dampers may have been taken out."""
    known = {p.symbol for p in eom.parameters}
    return {old: new for old, new in mapping.items() if old in known}


def _paper() -> dict[str, sp.Expr]:
    """Exact numbers behind `PAPER_VALUES`."""
    N_b, mass, hinge, arm = 4, sp.Rational(319, 10), sp.Rational(1, 5), sp.Rational(5, 2)
    fuselage, own_inertia = sp.Rational(29029, 10), sp.Integer(259)
    wx, wy, wb = 6 * sp.pi, 8 * sp.pi, 3 * sp.pi
    M, J = fuselage + N_b * mass, own_inertia + mass * arm**2
    return {
        "m_f": fuselage,
        "m": mass,
        "I": own_inertia,
        "a": hinge,
        "b": arm,
        "K_x": M * wx**2,
        "K_y": M * wy**2,
        "K_b": J * wb**2,
        "omega_x": wx,
        "omega_y": wy,
        "omega_b": wb,
        "r_m": mass * arm / M,
        "r_b": mass * arm / J,
        "r_a": sp.sqrt(hinge * mass * arm / J),
        "r_h": hinge / arm,
        **dict.fromkeys(("c_x", "c_y", "c_b", "mu_x", "mu_y", "mu_b"), sp.S.Zero),
    }


#: Numbers of the family of papers named above, N_b = 4: masses, lengths, inertia and frequencies
#: as published (m_f = 2902.9 kg, m = 31.9 kg, a = 0.2 m, b = 2.5 m, I = 259 kg m², ω_x = 6π,
#: ω_y = 8π, ω_b = 3π rad/s, no damping); stiffnesses and ratios follow from them exactly and are
#: rounded once. The rotor speed is the variable of the charts and has no value here.
PAPER_VALUES: dict[str, float] = {name: float(value) for name, value in _paper().items()}


def paper_values(eom: EquationsOfMotion) -> dict[str, float]:
    """Choose from `PAPER_VALUES` what the equations take; blades all have the common values."""
    values = {}
    for name in (p.name for p in eom.parameters):
        shared = name if name in PAPER_VALUES else name.rstrip("0123456789").rstrip("_")
        if shared in PAPER_VALUES:
            values[name] = PAPER_VALUES[shared]
    return values
