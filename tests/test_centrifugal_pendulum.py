"""The centrifugal pendulum: what is emitted against linear theory and the jump."""

from __future__ import annotations

import math

import numpy as np
import pytest
from entries import certificates, demand_fits, demand_notebook, emitted

NAME = "centrifugal_pendulum"


@pytest.mark.pinned
def test_the_notebook_of_the_centrifugal_pendulum() -> None:
    demand_notebook(NAME)


def test_certificates_of_the_centrifugal_pendulum() -> None:
    found = certificates(NAME)
    assert sorted(found) == [f"nu_is_omega_p_order_{n}" for n in (2, 4)]
    for data in found.values():
        # generic values: no error term vanishes; the next ones are a sixth of an order
        demand_fits(data, 0.2, even=True)


def exact_frequency(b: float, omega_r: float, omega_p: float) -> float:
    """The pendulum's mode of the linear system, from its two quadratic equations.

    With w = (1 + n²)ψ: (1 + b)w'' + bφ'' + ω_r²w = 0 and φ'' + w'' + ω_p²φ = 0.
    """
    stiffness = np.diag([omega_r**2, omega_p**2])
    mass = np.array([[1 + b, b], [1, 1]])
    squares = np.sort(np.linalg.eigvals(np.linalg.solve(mass, stiffness)).real)
    return float(np.sqrt(squares[np.argmin(np.abs(squares - omega_p**2))]))


def test_small_swings_have_the_frequency_of_linear_theory() -> None:
    """To order 4 in ε, b being of order 2: the error falls with the cube of b."""
    case = emitted(NAME, "nu_is_omega_p_order_4")
    values = {"omega_p": 1.3, "n": 1.7, "omega_r": 0.6, "mu": 0.0, "tau": 0.0, "sigma": 0.0}
    errors = []
    for b in (0.04, 0.02):
        rate = case.slow_flow([0.0, 1e-9], b=b, **values)[1] / 1e-9
        errors.append(1.3 + rate.imag - exact_frequency(b, 0.6, 1.3))
    # the next term is smaller by b times a coefficient of order one
    assert errors[0] / errors[1] == pytest.approx(8, rel=0.1)


def test_the_torque_at_which_a_circular_path_jumps() -> None:
    """a² = 8b/3 and (n² + 1)τ = (2b/3) √(8b/3) ω_p², the limit of a slow rotor."""
    b, n, omega_p = 0.06, 2.0, 1.3
    a = math.sqrt(8 * b / 3)
    tau = 2 * b / 3 * a * omega_p**2 / (n**2 + 1)
    case = emitted(NAME, "nu_is_omega_p_order_2")
    values = {"omega_p": omega_p, "n": n, "b": b, "mu": 0.0, "sigma": 0.0, "omega_r": 1e-9}

    def rest(size: float, torque: float) -> float:
        return abs(case.slow_flow([0.0, -size / 2], tau=torque, **values)[1])

    assert rest(a, tau) < 1e-16
    # a double root: rates grow with the square of the distance, their next term is 1e-3 smaller
    assert rest(a * 1.002, tau) / rest(a * 1.001, tau) == pytest.approx(4, rel=5e-3)
