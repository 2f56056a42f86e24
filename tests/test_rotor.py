"""The ground resonance model, against derivations by hand and by other methods.

The file under test stands among the derivations: the engine knows nothing of helicopters.
"""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
import rotor
import sympy as sp
from scipy import linalg
from sympy.physics.mechanics import dynamicsymbols

from mmsgen.equations import EquationsOfMotion
from mmsgen.errors import ModelError
from mmsgen.terms import expanded

t = dynamicsymbols._t
Omega = rotor.Omega


@pytest.fixture(scope="module", params=[2, 3, 4, 5])
def nonlinear(request: pytest.FixtureRequest) -> EquationsOfMotion:
    """Different blades, for several rotors."""
    return rotor.helicopter(request.param).equations_of_motion()


def names(eom: EquationsOfMotion) -> list[str]:
    """The parameters' names, in order."""
    return [parameter.name for parameter in eom.parameters]


def symbol(eom: EquationsOfMotion, name: str) -> sp.Symbol:
    """The parameter of that name."""
    return next(p.symbol for p in eom.parameters if p.name == name)


# --- nonlinear equations --------------------------------------------------------------------------


def test_power_balance(nonlinear: EquationsOfMotion) -> None:
    """Σ q' · (equation) = dH/dt + ∂L/∂t + 2R, an identity in q, q' and q'' for every Lagrangian.

    H = Σ q' ∂L/∂q' − L is Jacobi's integral: at Ω = 0 the energy, which then is conserved without
    dampers. Rayleigh's function takes 2R.
    """
    model = rotor.helicopter(len(nonlinear.coordinates) - 2)
    lagrangian, dissipation = model.lagrangian, model.dissipation
    velocities = [q.diff(t) for q in model.coordinates]
    plain = {v: sp.Symbol(f"v{j}") for j, v in enumerate(velocities)}
    back = {v: q for q, v in plain.items()}
    still = {q: sp.Symbol(f"u{j}") for j, q in enumerate(model.coordinates)}
    moving = {u: q for q, u in still.items()}
    frozen = lagrangian.xreplace(plain).xreplace(still)
    explicit = frozen.diff(t).xreplace(moving).xreplace(back)
    jacobi = sum(v * frozen.diff(v) for v in plain.values()) - frozen
    jacobi = expanded(jacobi).xreplace(moving).xreplace(back)
    power = sum(v * e for v, e in zip(velocities, nonlinear.equations, strict=True))
    balance = power - jacobi.diff(t) - explicit - 2 * dissipation
    assert expanded(balance) == 0
    assert expanded(balance + dissipation) != 0


def test_equations_are_the_variation_of_the_action() -> None:
    """δS = −∫ Σ η·(equation) dt for any path q and any η that vanishes at both ends.

    Both sides by quadrature, with nothing but the Lagrangian on the left: a difference quotient of
    the action in 40 digits. This sees gyroscopic terms, on which power has no hold.
    """
    eom = rotor.undamped(rotor.helicopter(2).equations_of_motion())
    model = rotor.helicopter(2)
    values = {p.symbol: sp.Rational(n + 3, 7) for n, p in enumerate(model.parameters)}
    path = [sp.sin(t) / 3, t**2 / 2 - t, sp.cos(2 * t) / 2 + t, sp.exp(-t) - t / 5]
    bump = [t * (1 - t) * (j + 1 - j * t) for j in range(4)]

    def along(expr: sp.Expr, curve: list[sp.Expr]) -> object:
        replaced = dict(zip(model.coordinates, curve, strict=True))
        with_motion = {
            q.diff(t, order): c.diff(t, order) for q, c in replaced.items() for order in (0, 1, 2)
        }
        return sp.lambdify(t, expr.xreplace(with_motion).xreplace(values), "mpmath")

    # the equations were divided by their inertia, which is undone here
    masses = [values[symbol(eom, n)] for n in ("m_f", "m_1", "m_2", "I_1", "I_2", "b")]
    total = masses[0] + masses[1] + masses[2]
    inertia = [total, total, *(masses[3 + j] + masses[1 + j] * masses[5] ** 2 for j in (0, 1))]
    weighted = sum(
        i * e * sp.Symbol(f"eta{j}")
        for j, (i, e) in enumerate(zip(inertia, eom.equations, strict=True))
    ).xreplace({sp.Symbol(f"eta{j}"): b for j, b in enumerate(bump)})
    with mpmath.workdps(40):
        step = mpmath.mpf(10) ** -10

        def action(sign: int) -> mpmath.mpf:
            shift = sp.Rational(sign, 10**10)
            curve = [q + shift * b for q, b in zip(path, bump, strict=True)]
            return mpmath.quad(along(model.lagrangian, curve), [0, 1])

        variation = (action(1) - action(-1)) / (2 * step)
        work = -mpmath.quad(along(weighted, path), [0, 1])
        # the difference quotient is off by (step²/6)·S''' ≈ 1e-20 × O(10), rounding by
        # 1e-40/step = 1e-30, the quadrature of these entire functions by less
        assert abs(variation - work) < 1e-18
        assert abs(work) > 0.1


# --- linear equations -----------------------------------------------------------------------------


def by_hand(eom: EquationsOfMotion) -> list[sp.Expr]:
    """Linear equations of alike blades in ratios.

    To first order, x_k = x + (a + b) cos ζ_k − b φ_k sin ζ_k and y_k = y + (a + b) sin ζ_k
    + b φ_k cos ζ_k. The constant radius gives forces (a + b) Ω² cos ζ_k whose sum over equally
    spaced blades vanishes. Newton for the whole helicopter, of mass M:
        M x'' + c_x x' + K_x x = m b Σ (φ_k sin ζ_k)'',   M y'' + … = −m b Σ (φ_k cos ζ_k)''.
    Moments about hinge k: J φ_k'' + c_b φ_k' + K_b φ_k = moment of the hinge's acceleration,
    −m b (y'' cos ζ_k − x'' sin ζ_k), and of the centrifugal force, which points from the hub and
    has the lever a sin φ_k: −m b a Ω² φ_k. Divided by M and by J these are the equations below.
    """
    N = len(eom.coordinates) - 2
    x, y, *phi = eom.coordinates
    zeta = [Omega * t + 2 * sp.pi * sp.Rational(k, N) for k in range(N)]
    sines = sum(p * sp.sin(z) for p, z in zip(phi, zeta, strict=True))
    cosines = sum(p * sp.cos(z) for p, z in zip(phi, zeta, strict=True))
    r_m, r_b, r_a, w_x, w_y, w_b, mu_x, mu_y, mu_b = (
        symbol(eom, n) for n in "r_m r_b r_a omega_x omega_y omega_b mu_x mu_y mu_b".split()
    )
    fuselage = [
        x.diff(t, 2) + 2 * mu_x * x.diff(t) + w_x**2 * x - r_m * sines.diff(t, 2),
        y.diff(t, 2) + 2 * mu_y * y.diff(t) + w_y**2 * y + r_m * cosines.diff(t, 2),
    ]
    blades = [
        p.diff(t, 2)
        + 2 * mu_b * p.diff(t)
        + (w_b**2 + r_a**2 * Omega**2) * p
        + r_b * (y.diff(t, 2) * sp.cos(z) - x.diff(t, 2) * sp.sin(z))
        for p, z in zip(phi, zeta, strict=True)
    ]
    return fuselage + blades


RATIOS = "Omega r_m r_b r_a omega_x omega_y mu_x mu_y mu_b omega_b".split()


def test_linear_equations_in_ratios(nonlinear: EquationsOfMotion) -> None:
    eom = rotor.in_ratios(rotor.isotropic(nonlinear).linearise())
    assert names(eom) == RATIOS
    for mine, other in zip(eom.equations, by_hand(eom), strict=True):
        assert expanded(mine - other) == 0
    assert eom.f == sp.zeros(len(eom.coordinates), 1)
    assert all(p.unit and p.meaning for p in eom.parameters)


def test_steps_commute_with_linearising(nonlinear: EquationsOfMotion) -> None:
    first = rotor.in_ratios(rotor.isotropic(nonlinear.linearise()))
    last = rotor.in_ratios(rotor.isotropic(nonlinear)).linearise()
    assert first.equations == last.equations
    assert first.parameters == last.parameters


def test_nonlinear_equations_in_ratios() -> None:
    eom = rotor.in_ratios(rotor.isotropic(rotor.helicopter(3).equations_of_motion()))
    assert names(eom) == RATIOS
    x, y, phi, *_ = eom.coordinates
    s = {name: symbol(eom, name) for name in RATIOS}
    zeta = Omega * t + phi
    by_hand_again = (  # the linear blade equation, its moments taken in the turned position
        phi.diff(t, 2)
        + 2 * s["mu_b"] * phi.diff(t)
        + s["omega_b"] ** 2 * phi
        + s["r_a"] ** 2 * Omega**2 * sp.sin(phi)
        + s["r_b"] * (y.diff(t, 2) * sp.cos(zeta) - x.diff(t, 2) * sp.sin(zeta))
    )
    assert sp.expand(eom.equations[2] - by_hand_again) == 0


def test_there_and_back() -> None:
    """The definitions of the ratios undo what `in_ratios` does."""
    alike = rotor.isotropic(rotor.helicopter(4).equations_of_motion()).linearise()
    ratios = rotor.in_ratios(alike)
    M, J = rotor.m_f + 4 * rotor.m, rotor.inertia + rotor.m * rotor.b**2
    definitions = {
        rotor.r_m: rotor.m * rotor.b / M,
        rotor.r_b: rotor.m * rotor.b / J,
        rotor.r_a: sp.sqrt(rotor.a * rotor.m * rotor.b / J),
        rotor.omega_x: sp.sqrt(rotor.K_x / M),
        rotor.omega_y: sp.sqrt(rotor.K_y / M),
        rotor.omega_b: sp.sqrt(rotor.K_b / J),
        rotor.mu_x: rotor.c_x / (2 * M),
        rotor.mu_y: rotor.c_y / (2 * M),
        rotor.mu_b: rotor.c_b / (2 * J),
    }
    back = ratios.reparametrise(definitions)
    assert set(names(back)) == set(names(alike))
    assert back.reparametrise({}).equations == alike.reparametrise({}).equations


def test_conservative_systems_are_self_adjoint(nonlinear: EquationsOfMotion) -> None:
    """Helmholtz's conditions: M = Mᵀ, C + Cᵀ = 2 M', K − Kᵀ = (C − M')', without dampers."""
    dampers = {p.symbol: 0 for p in nonlinear.parameters if p.name.startswith("c_")}
    M, C, K = (matrix.xreplace(dampers) for matrix in (nonlinear.M, nonlinear.C, nonlinear.K))
    assert M == M.T
    assert (C + C.T - 2 * M.diff(t)).applyfunc(expanded).is_zero_matrix
    assert (K - K.T - (C - M.diff(t)).diff(t)).applyfunc(expanded).is_zero_matrix
    assert not C.is_zero_matrix


def test_lag_frequency_at_speed() -> None:
    ratios = rotor.in_ratios(rotor.isotropic(rotor.helicopter(4).equations_of_motion()).linearise())
    eom = rotor.at_speed(ratios)
    assert names(eom) == [
        *"Omega r_m r_b omega_x omega_y mu_x mu_y mu_b omega_phi".split(),
        *"r_a omega_b".split(),  # for the definition alone
    ]
    used = {s.name for equation in eom.equations for s in equation.free_symbols}
    assert used == {*"t Omega r_m r_b omega_x omega_y mu_x mu_y mu_b omega_phi".split()}
    lag = next(p for p in eom.parameters if p.name == "omega_phi")
    assert lag.definition == sp.sqrt(rotor.omega_b**2 + rotor.r_a**2 * Omega**2)
    put_back = [e.xreplace({lag.symbol: lag.definition}) for e in eom.equations]
    for mine, other in zip(put_back, ratios.equations, strict=True):
        assert sp.expand(mine - other) == 0


def test_undamped_rotors() -> None:
    alike = rotor.isotropic(rotor.helicopter(4).equations_of_motion()).linearise()
    before = rotor.in_ratios(rotor.undamped(alike))
    after = rotor.undamped(rotor.in_ratios(alike))
    assert before.equations == after.equations
    assert names(before) == names(after) == "Omega r_m r_b r_a omega_x omega_y omega_b".split()


def test_one_different_blade() -> None:
    """Every blade its lag stiffness: own frequencies, all else as in the isotropic rotor."""
    eom = rotor.undamped(rotor.helicopter(4).equations_of_motion()).linearise()
    own = rotor.in_ratios(rotor.isotropic(eom, own_stiffness=True))
    frequencies = [f"omega_b{k}" for k in range(1, 5)]
    assert names(own) == [*"Omega r_m r_b r_a omega_x omega_y".split(), *frequencies]
    same = own.reparametrise({name: rotor.omega_b for name in frequencies})
    assert same.equations == rotor.in_ratios(rotor.isotropic(eom)).equations

    speed = rotor.at_speed(own)
    assert [n for n in names(speed) if "phi" in n] == [f"omega_phi{k}" for k in range(1, 5)]
    assert speed.K[3, 3] == symbol(speed, "omega_phi2") ** 2
    assert set(rotor.paper_values(own)) == set(names(own)) - {"Omega"}


def test_different_masses_do_not_reduce_to_ratios_of_alike_blades() -> None:
    eom = rotor.helicopter(2).equations_of_motion()
    with pytest.raises(ModelError, match="did not cancel"):
        rotor.in_ratios(eom.reparametrise({"m_1": rotor.m, "I_1": rotor.inertia}))


@pytest.mark.parametrize("N_b", [1, 0, -3, 2.0, True, "4"])
def test_number_of_blades(N_b: object) -> None:
    with pytest.raises(ModelError, match="N_b >= 2"):
        rotor.helicopter(N_b)  # type: ignore[arg-type]


# --- numbers --------------------------------------------------------------------------------------


def test_numbers_of_the_paper() -> None:
    values = rotor.PAPER_VALUES
    M = values["m_f"] + 4 * values["m"]
    J = values["I"] + values["m"] * values["b"] ** 2
    # each number rounded once and three roundings here: 4 half units of 2⁻⁵²
    close = pytest.approx
    assert values["r_m"] == 1 / 38
    assert values["r_b"] == close(0.17398418325606767, rel=5e-16)
    assert values["r_a"] ** 2 == close(0.034796836651213525, rel=5e-16)
    assert values["K_x"] == close(M * (6 * np.pi) ** 2, rel=1e-15)
    assert values["K_b"] == close(J * (3 * np.pi) ** 2, rel=1e-15)


def multiblade(eom: EquationsOfMotion) -> list[sp.Expr]:
    """The equations of a four-bladed rotor in non-rotating (Coleman) coordinates.

    φ_k = z_0 + (−1)^k z_d + z_c cos ζ_k + z_s sin ζ_k; the blade equations are projected on
    cos ζ_k and sin ζ_k. Of an isotropic rotor the result does not depend on time any more.
    """
    phi = eom.coordinates[2:]
    collective, cyclic_c, cyclic_s, odd = dynamicsymbols("z_0 z_c z_s z_d")
    zeta = [Omega * t + sp.pi * k / 2 for k in range(4)]
    motion = {
        p: collective + (-1) ** k * odd + cyclic_c * sp.cos(z) + cyclic_s * sp.sin(z)
        for k, (p, z) in enumerate(zip(phi, zeta, strict=True))
    }
    replaced = {
        p.diff(t, order): m.diff(t, order) for p, m in motion.items() for order in (2, 1, 0)
    }
    fixed = [equation.xreplace(replaced) for equation in eom.equations]
    return [
        expanded(fixed[0]),
        expanded(fixed[1]),
        expanded(sum(e * sp.cos(z) for e, z in zip(fixed[2:], zeta, strict=True)) / 2),
        expanded(sum(e * sp.sin(z) for e, z in zip(fixed[2:], zeta, strict=True)) / 2),
    ]


def test_multiblade_equations_are_constant_in_time_and_give_known_frequencies() -> None:
    """Coupled frequencies at Ω = 33 rad/s, from an independent computation in 12 digits."""
    alike = rotor.undamped(rotor.isotropic(rotor.helicopter(4).equations_of_motion()))
    eom = rotor.in_ratios(alike.linearise())
    equations = multiblade(eom)
    unknowns = [*eom.coordinates[:2], *dynamicsymbols("z_c z_s")]
    matrices = []
    for order in (2, 1, 0):
        motion = [z.diff(t, order) for z in unknowns]
        matrices.append(sp.Matrix(4, 4, lambda i, j, v=motion: equations[i].coeff(v[j])))
    assert all(matrix.is_zero_matrix for matrix in (m.diff(t) for m in matrices))
    left = [sp.Matrix(equations)]
    for order, matrix in zip((2, 1, 0), matrices, strict=True):
        left.append(matrix * sp.Matrix([z.diff(t, order) for z in unknowns]))
    assert (left[0] - left[1] - left[2] - left[3]).applyfunc(sp.expand).is_zero_matrix

    values = {p.symbol: rotor.PAPER_VALUES.get(p.name, 33.0) for p in eom.parameters}
    M, C, K = (np.array(matrix.xreplace(values), dtype=float) for matrix in matrices)
    first_order = np.block(
        [[np.zeros((4, 4)), np.eye(4)], [-linalg.solve(M, K), -linalg.solve(M, C)]]
    )
    found = np.sort(linalg.eigvals(first_order).imag)[4:]
    known = [19.0880287552, 21.6131048419, 24.6101094693, 45.3153929059]
    # known are rounded at 5e-11; the eigenvalues are simple and of size 50, conditioned by less
    # than 1e3: 1e3·50·1e-16
    np.testing.assert_allclose(found, known, rtol=0, atol=6e-11)
