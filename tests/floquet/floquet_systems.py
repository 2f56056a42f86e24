"""Linear systems with known stability, written by hand for the tests."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import sympy as sp
from scipy.optimize import linear_sum_assignment
from sympy.physics.mechanics import dynamicsymbols

from mmsgen.parameters import Parameter

TIME = dynamicsymbols._t
ROTOR = {
    "r_m": 1 / 38,
    "r_b": 0.17398418325606767,
    "r_a": 0.034796836651213525**0.5,
    "omega_x": 6 * np.pi,
    "omega_y": 8 * np.pi,
    "omega_b": 3 * np.pi,
}


@dataclass(frozen=True)
class Linear:
    """M q'' + C q' + K q = f, with the attributes of EquationsOfMotion that Floquet reads."""

    M: sp.ImmutableDenseMatrix
    C: sp.ImmutableDenseMatrix
    K: sp.ImmutableDenseMatrix
    parameters: tuple[Parameter, ...] = ()
    time: sp.Symbol = TIME


def linear(mass, damping, stiffness, definitions=None) -> Linear:
    """A system of matrices (or scalars); its free symbols are its parameters."""
    matrices = [
        sp.ImmutableDenseMatrix(m if isinstance(m, sp.MatrixBase) else [[m]])
        for m in (mass, damping, stiffness)
    ]
    symbols = set().union(*(m.free_symbols for m in matrices)) - {TIME}
    for expression in (definitions or {}).values():
        symbols |= expression.free_symbols
    parameters = tuple(
        Parameter(s, definition=(definitions or {}).get(s))
        for s in sorted(symbols, key=lambda s: s.name)
    )
    return Linear(*matrices, parameters)


def mathieu() -> Linear:
    """w'' + 2c w' + (a - 2q cos 2t) w = 0."""
    a, q, c = sp.symbols("a q c", real=True)
    return linear(1, 2 * c, a - 2 * q * sp.cos(2 * TIME))


def rotor(blades: int = 4) -> Linear:
    """Ground resonance, one lag frequency for each blade: design of the model, linearised by hand.

    x'' + ωx²x - r_m Σ (φ_k sin ζ_k)'' = 0, y'' + ωy²y + r_m Σ (φ_k cos ζ_k)'' = 0,
    φ_k'' + (ω_bk² + r_a²Ω²)φ_k + r_b(-x'' sin ζ_k + y'' cos ζ_k) = 0, ζ_k = Ωt + 2π(k-1)/N.
    """
    speed, r_m, r_b, r_a = sp.symbols("Omega r_m r_b r_a", positive=True)
    omega_x, omega_y = sp.symbols("omega_x omega_y", positive=True)
    lag = sp.symbols(f"omega_b1:{blades + 1}", positive=True)
    size = blades + 2
    mass, damping, stiffness = sp.eye(size), sp.zeros(size), sp.zeros(size)
    stiffness[0, 0], stiffness[1, 1] = omega_x**2, omega_y**2
    for k in range(blades):
        j = k + 2
        azimuth = speed * TIME + 2 * sp.pi * k / sp.Integer(blades)
        sine, cosine = sp.sin(azimuth), sp.cos(azimuth)
        for row, arm in ((0, -r_m * sine), (1, r_m * cosine)):
            # (φ arm)'' = arm φ'' + 2 arm' φ' + arm'' φ
            mass[row, j] = arm
            damping[row, j] = 2 * sp.diff(arm, TIME)
            stiffness[row, j] = sp.diff(arm, TIME, 2)
        mass[j, 0], mass[j, 1] = -r_b * sine, r_b * cosine
        stiffness[j, j] = lag[k] ** 2 + r_a**2 * speed**2
    return linear(mass, damping, stiffness)


def isotropic(blades: int = 4, **changed: object) -> dict[str, object]:
    """The rotor's numbers, all blades alike unless changed."""
    values: dict[str, object] = {k: v for k, v in ROTOR.items() if k != "omega_b"}
    values |= {f"omega_b{k}": ROTOR["omega_b"] for k in range(1, blades + 1)}
    return values | changed


def multiblade_exponents(speed: float, blades: int = 4) -> npt.NDArray[np.complex128]:
    """Eigenvalues of the isotropic rotor in multiblade (Coleman) coordinates.

    With φ_k = c cos ζ_k + s sin ζ_k + (modes that do not move the hub) the sums are
    Σ φ_k sin ζ_k = N s/2 and Σ φ_k cos ζ_k = N c/2, and the equations in (x, y, c, s) are
    x'' + ωx²x - r_m N s''/2 = 0, y'' + ωy²y + r_m N c''/2 = 0,
    c'' + 2Ωs' + (ω_φ² - Ω²)c + r_b y'' = 0, s'' - 2Ωc' + (ω_φ² - Ω²)s - r_b x'' = 0.
    """
    v = ROTOR
    half = v["r_m"] * blades / 2
    omega_phi2 = v["omega_b"] ** 2 + (v["r_a"] * speed) ** 2
    mass = np.eye(4)
    mass[0, 3], mass[1, 2], mass[2, 1], mass[3, 0] = -half, half, v["r_b"], -v["r_b"]
    gyro = np.zeros((4, 4))
    gyro[2, 3], gyro[3, 2] = 2 * speed, -2 * speed
    rest = omega_phi2 - speed**2
    stiffness = np.diag([v["omega_x"] ** 2, v["omega_y"] ** 2, rest, rest])
    first_order = np.block(
        [
            [np.zeros((4, 4)), np.eye(4)],
            [-np.linalg.solve(mass, stiffness), -np.linalg.solve(mass, gyro)],
        ]
    )
    idle = 1j * np.sqrt(omega_phi2)
    return np.concatenate([np.linalg.eigvals(first_order), [idle, -idle] * (blades - 2)])


def distance_modulo(left, right, frequency: float) -> npt.NDArray[np.float64]:
    """Distances of two sets of exponents, paired best, modulo i·frequency."""
    difference = np.subtract.outer(np.asarray(left), np.asarray(right))
    turns = np.round(difference.imag / frequency)
    gap = np.abs(difference - 1j * turns * frequency)
    row, column = linear_sum_assignment(gap)
    return gap[row, column]


def rotating(m0, c0, k0, speed: sp.Symbol) -> Linear:
    """M₀p'' + C₀p' + K₀p = 0 with constant 2x2 matrices, seen in q = R(Ωt)p.

    Periodic coefficients whose exponents are the constant system's, modulo iΩ: a system
    A(t) = B + e^{Bt} A₀ e^{-Bt} in second-order form, with M(t) varying too.
    """
    angle = speed * TIME
    turn = sp.Matrix([[sp.cos(angle), -sp.sin(angle)], [sp.sin(angle), sp.cos(angle)]])
    j = sp.Matrix([[0, -1], [1, 0]])
    m0, c0, k0 = sp.Matrix(m0), sp.Matrix(c0), sp.Matrix(k0)
    mass, damping, stiffness = (turn * m * turn.T for m in (m0, c0, k0))
    return linear(
        mass,
        damping - 2 * speed * mass * j,
        stiffness - speed * damping * j - speed**2 * mass,
    )
