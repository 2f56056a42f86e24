"""The forms of one slow flow against each other, and the frame that makes it autonomous."""

from __future__ import annotations

import cmath

import numpy as np
import pytest
import sympy as sp
from systems import (
    A,
    Ac,
    B,
    Omega,
    Omega_2,
    alpha,
    beta,
    d,
    duffing,
    equations,
    f,
    k,
    kappa,
    mathieu,
    mu,
    omega,
    omega_1,
    omega_2,
    oscillator,
    pair,
    same,
    sigma,
    sigma_1,
    sigma_2,
    t,
    theta,
    x,
    y,
    z,
)

from mmsgen.errors import ExpansionError
from mmsgen.slowflow import SlowFlow

I = sp.I  # noqa: E741


def nonlinear() -> SlowFlow:
    """Two relations, a static phase, damping, second order."""
    left = [
        d(x, 2)
        + omega_1**2 * x
        + alpha * x * y
        + mu * d(x)
        - f * sp.cos(Omega * t + theta)
        + kappa * sp.cos(2 * Omega * t) * x,
        d(y, 2) + omega_2**2 * y + beta * x**2 + mu * d(y),
    ]
    scaled = equations(left, (x, y)).scale({f: 1, alpha: 1, beta: 1, mu: 1, kappa: 1})
    return scaled.expand(2, {Omega: omega_1, omega_2: 2 * omega_1}).slow_flow


def rotating() -> SlowFlow:
    """Linear, with e^{2πik/3} and √3 in its coefficients."""
    c = [sp.cos(Omega * t + 2 * sp.pi * sp.Rational(j, 3)) for j in range(3)]
    left = [
        d(x, 2) + omega_1**2 * x + alpha * (c[0] * y + c[1] * z) + mu * d(x),
        d(y, 2) + omega_2**2 * y + beta * c[2] * x + mu * d(y),
        d(z, 2) + omega_2**2 * z + beta * c[1] * x + mu * d(z),
    ]
    scaled = equations(left, (x, y, z)).scale({alpha: 1, beta: 1, mu: 1})
    return scaled.expand(2, {Omega: omega_1 + omega_2}).slow_flow


FLOWS = {"nonlinear": nonlinear, "rotating": rotating}


def evaluated(expression: sp.Expr, values: dict[sp.Expr, complex]) -> complex:
    """A value in doubles, conjugates of amplitudes included."""
    symbols = sorted(values, key=str)
    numbers = [values[s] for s in symbols]
    return complex(sp.lambdify(symbols, expression, "numpy")(*numbers))


def sample(flow: SlowFlow, seed: int) -> dict[sp.Expr, complex]:
    """Numbers for all parameters and amplitudes."""
    random = np.random.default_rng(seed)
    values: dict[sp.Expr, complex] = {
        p.symbol: float(random.uniform(0.5, 1.5)) for p in flow.case.parameters
    }
    for a in flow.case.amplitudes:
        values[a] = complex(*random.uniform(-1, 1, 2))
    return values


# Sums of at most 100 products of numbers of size 1 with small rational factors, in doubles.
CLOSE = {"rel": 1e-11, "abs": 1e-11}


@pytest.mark.parametrize("name", FLOWS)
@pytest.mark.parametrize("seed", range(3))
def test_the_forms_agree(name: str, seed: int) -> None:
    flow = FLOWS[name]()
    values = sample(flow, seed)
    case, when = flow.case, 0.37
    base = {s: v for s, v in values.items() if s not in case.amplitudes}
    turned, polar, cartesian = dict(base), dict(base), dict(base)
    rates = {}
    for j, (a, q) in enumerate(zip(case.amplitudes, case.coordinates, strict=True)):
        b = values[a]
        rates[a] = evaluated(
            flow.frame_rate(j) + 0 * sigma, {**base, sigma: base.get(sigma, 0)}
        ).real
        turned[a] = b * cmath.exp(1j * rates[a] * when)
        polar[sp.Symbol(f"a_{q.func}", nonnegative=True)] = 2 * abs(b)
        polar[sp.Symbol(f"gamma_{q.func}", real=True)] = cmath.phase(b)
        cartesian[sp.Symbol(f"u_{q.func}", real=True)] = 2 * b.real
        cartesian[sp.Symbol(f"v_{q.func}", real=True)] = 2 * b.imag
    for j, (a, q) in enumerate(zip(case.amplitudes, case.coordinates, strict=True)):
        b = values[a]
        rate = evaluated(flow.autonomous[a], values)
        moving = evaluated(flow.complex[a], {**turned, t: when})
        assert moving == pytest.approx(
            (rate + 1j * rates[a] * b) * cmath.exp(1j * rates[a] * when), **CLOSE
        )
        names = [
            sp.Symbol(f"{n}_{q.func}", **kind)
            for n, kind in (
                ("a", {"nonnegative": True}),
                ("gamma", {"real": True}),
                ("u", {"real": True}),
                ("v", {"real": True}),
            )
        ]
        radial, angular = (evaluated(flow.polar[n], polar) for n in names[:2])
        forward, sideways = (evaluated(flow.cartesian[n], cartesian) for n in names[2:])
        assert (radial / 2 + 1j * abs(b) * angular) * b / abs(b) == pytest.approx(rate, **CLOSE)
        assert (forward + 1j * sideways) / 2 == pytest.approx(rate, **CLOSE)
        assert max(abs(v.imag) for v in (radial, angular, forward, sideways)) < 1e-12
        assert len(case.coordinates) * 2 == flow.jacobian.rows, j


def test_real_forms_hold_no_imaginary_unit() -> None:
    for flow in (nonlinear(), rotating()):
        for form in (flow.polar, flow.cartesian):
            assert not any(e.has(I, sp.conjugate, sp.re, sp.im) for e in form.values())


def test_real_forms_of_plain_symbols() -> None:
    """A parameter without assumptions is real, in a phase too."""
    plain, strength = sp.Symbol("delta"), sp.Symbol("eta")
    eom = oscillator(alpha * x**3 - strength * f * sp.cos(Omega * t + plain))
    flow = eom.scale({alpha: 1, f: 1}).expand(1, {Omega: omega}).slow_flow
    for form in (flow.polar, flow.cartesian):
        assert not any(e.has(I, sp.conjugate, sp.re, sp.im) for e in form.values())


def test_the_jacobian_is_the_derivative() -> None:
    """Central differences of the Cartesian flow, which is a polynomial of degree 3 at most.

    Step 1e-3: error below h² times third derivatives of size 1, and rounding 1e-13 over h.
    """
    flow = nonlinear()
    random = np.random.default_rng(5)
    names = [*(p.symbol for p in flow.case.parameters), *flow.cartesian]
    point = random.uniform(0.5, 1.5, len(names))
    rates = sp.lambdify(names, list(flow.cartesian.values()), "numpy")
    jacobian = np.array(sp.lambdify(names, flow.jacobian, "numpy")(*point))
    for column in range(4):
        step = np.zeros(len(names))
        step[len(flow.case.parameters) + column] = 1e-3
        slope = (np.array(rates(*(point + step))) - np.array(rates(*(point - step)))) / 2e-3
        assert np.allclose(jacobian[:, column], slope, atol=1e-5)
    assert abs(jacobian).max() > 0.1


def test_matrix_and_jacobian_of_a_linear_flow() -> None:
    """Eigenvalues of the Jacobian are those of the matrix and their conjugates.

    The eigenvalue problems are of size 6 with entries of size 1 and well separated eigenvalues.
    """
    flow = rotating()
    values = {
        p.symbol: v
        for p, v in zip(flow.case.parameters, (0.3, 0.2, 0.05, 1.1, 1.7, 2.8, 0.04), strict=False)
    }
    values = {p.symbol: values.get(p.symbol, 0.07) for p in flow.case.parameters}
    numbers = {str(s): v for s, v in values.items()}
    matrix = np.array(flow.matrix.subs(values).evalf(), dtype=complex)
    jacobian = np.array(flow.jacobian.subs(values).evalf(), dtype=float)
    half = np.linalg.eigvals(matrix)
    both = np.concatenate((half, half.conj()))
    whole = np.linalg.eigvals(jacobian)
    assert np.allclose(np.sort_complex(both.round(9)), np.sort_complex(whole.round(9)), atol=1e-8)
    # One of two conjugate sets may be kept for each block: the real parts are all there.
    own = {n: v for n, v in numbers.items() if n != "Omega"}  # it follows from the detuning
    assert flow.growth_rate(own) == pytest.approx(whole.real.max(), abs=1e-10)


def test_the_frame_by_hand() -> None:
    """Ω = 2ω + σ turns A at σ/2; Ω = ω_1 + ω_2 + σ turns A_y at σ and leaves the first at rest."""
    assert mathieu().expand(1, {Omega: 2 * omega}).slow_flow.frame == ({sigma: sp.Rational(1, 2)},)
    assert rotating().frame == ({}, {sigma: 1}, {sigma: 1})
    one, two = nonlinear().frame
    assert one == {sigma_1: 1} and two == {sigma_1: 2}
    assert duffing().expand(2).slow_flow.frame == ({},)


def test_autonomous_form_by_hand() -> None:
    """Mathieu: B' = −iσB/2 + iαB̄/(2ω)."""
    flow = mathieu().expand(1, {Omega: 2 * omega}).slow_flow
    assert same(flow.autonomous[A], -I * sigma * A / 2 + I * alpha * Ac / (2 * omega))
    assert same(flow.complex[A], I * alpha * Ac * sp.exp(I * sigma * t) / (2 * omega))


def test_two_excitations_near_one_frequency_have_no_frame() -> None:
    """Each detuning turns its own term: the complex form keeps the time, the others say why not."""
    terms = alpha * x**3 - f * sp.cos(Omega * t) - k * sp.cos(Omega_2 * t)
    scaled = oscillator(terms).scale({alpha: 1, f: 1, k: 1})
    flow = scaled.expand(1, {Omega: omega, Omega_2: omega}).slow_flow
    assert flow.frame is None
    assert flow.complex[A].has(sp.exp(I * sigma_1 * t)) and flow.complex[A].has(sigma_2)
    for form in ("polar", "cartesian", "autonomous", "jacobian"):
        with pytest.raises(ExpansionError, match="incommensurate detunings"):
            getattr(flow, form)
    linear = oscillator(2 * alpha * sp.cos(Omega * t) * x + 2 * beta * sp.cos(Omega_2 * t) * x)
    case = linear.scale({alpha: 1, beta: 1}).expand(1, {Omega: 2 * omega, Omega_2: 2 * omega})
    assert case.slow_flow.is_linear
    for attempt in (
        lambda: case.slow_flow.matrix,
        lambda: case.slow_flow.characteristic_polynomial(sp.Symbol("Gamma")),
        lambda: case.slow_flow.boundary(),
        lambda: case.slow_flow.growth_rate({}),
    ):
        with pytest.raises(ExpansionError, match=r"use \.complex"):
            attempt()


def test_nonlinear_flows_have_no_matrix() -> None:
    flow = duffing().expand(1).slow_flow
    assert not flow.is_linear
    with pytest.raises(ExpansionError, match=r"nonlinear or forced.*jacobian"):
        _ = flow.matrix
    forced = oscillator(mu * d(x) - f * sp.cos(Omega * t)).scale({mu: 1, f: 1})
    assert not forced.expand(1, {Omega: omega}).slow_flow.is_linear


def test_a_phase_common_to_all_terms_turns_the_amplitudes_only() -> None:
    """cos(Ωt + θ) everywhere: the matrix holds e^{±iθ}, growth and polynomial do not."""
    Gamma = sp.Symbol("Gamma")

    def flow_at(angle: sp.Expr) -> SlowFlow:
        c = 2 * sp.cos(Omega * t + angle)
        scaled = pair(alpha * c * y, beta * c * x).scale({alpha: 1, beta: 1})
        return scaled.expand(2, {Omega: omega_1 + omega_2}).slow_flow

    plain, turned = flow_at(sp.Integer(0)), flow_at(theta)
    assert plain.characteristic_polynomial(Gamma) == turned.characteristic_polynomial(Gamma)
    assert same(turned.matrix[0, 1], plain.matrix[0, 1] * sp.exp(I * theta))
    assert same(turned.matrix[1, 0], plain.matrix[1, 0] * sp.exp(-I * theta))
    variables = sp.Matrix(turned.variables)
    product = turned.matrix * variables
    assert same(product[0], turned.autonomous[A])
    assert turned.variables == (A, sp.conjugate(B))


@pytest.mark.parametrize(
    ("in_x", "in_y"),
    [
        (sp.cos(Omega * t + theta), sp.cos(Omega * t)),
        (sp.cos(Omega * t + theta) + sp.cos(Omega * t),) * 2,
        (sp.cos(Omega * t + theta) + sp.cos(Omega * t - theta),) * 2,
    ],
    ids=["one of two", "in one term", "standing"],
)
def test_phases_that_matter_are_refused(in_x: sp.Expr, in_y: sp.Expr) -> None:
    """f_12 f_21 e^{iθ} decides, or 1 + e^{iθ}: not rational in the parameters, but cos θ is."""
    scaled = pair(2 * alpha * in_x * y, 2 * beta * in_y * x).scale({alpha: 1, beta: 1})
    flow = scaled.expand(1, {Omega: omega_1 + omega_2}).slow_flow
    with pytest.raises(ExpansionError, match=r"constant phase .*theta.*two parameters"):
        _ = flow.matrix
    assert flow.jacobian.has(theta)


def test_phases_as_two_parameters() -> None:
    """The way out that the message names: c cos Ωt − s sin Ωt, checked at c² + s² = 1."""
    c, s = sp.symbols("c s", real=True)
    excitation = c * sp.cos(Omega * t) - s * sp.sin(Omega * t)
    scaled = pair(2 * alpha * excitation * y, 2 * beta * sp.cos(Omega * t) * x)
    flow = scaled.scale({alpha: 1, beta: 1}).expand(1, {Omega: omega_1 + omega_2}).slow_flow
    numbers = {"alpha": 0.1, "beta": 0.2, "omega_1": 1.0, "omega_2": 2.0, "sigma": 0.03}
    for angle in (0.0, 0.7, 2.0):
        rate = flow.growth_rate({**numbers, "c": np.cos(angle), "s": np.sin(angle)})
        # Γ² − iσΓ − αβe^{iθ}/(4ω_1ω_2) = 0 by hand from the two amplitude equations.
        roots = np.roots([1, -0.03j, -0.02 * np.exp(1j * angle) / 8])
        other = np.roots([1, -0.03j, -0.02 * np.exp(-1j * angle) / 8])
        assert min(abs(rate - r.real.max()) for r in (roots, other)) < 1e-14
