"""Figures: axes that a user can restyle, drawn without a display."""

from __future__ import annotations

import os
import subprocess
import sys

import numpy as np
import pytest

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.axes import Axes  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402

from mmsgen import plotting  # noqa: E402
from mmsgen.certificate import Certificate, Fit, fit_exponent  # noqa: E402

SPEEDS = np.linspace(4.0, 6.0, 21)
CURVES = {f"order {k}": np.clip(k - (SPEEDS - 5) ** 2, 0, None) for k in range(1, 9)}
REFERENCE = (SPEEDS[::5], CURVES["order 2"][::5])
EPSILONS = tuple(2.0**-k for k in range(3, 15))


def certificate(order: int, relation: str = "Omega = 2*omega") -> Certificate:
    fits = tuple(
        fit_exponent(q, order + 1, EPSILONS, [c * e ** (order + 1) for e in EPSILONS], [1e-15] * 12)
        for q, c in (("characteristic exponents", 1.0), ("edges of the zone", 0.5))
    )
    return Certificate(relation, order, (), fits)


@pytest.fixture(autouse=True)
def no_figure_left() -> object:
    plt.close("all")
    yield
    plt.close("all")


def test_growth_rates_on_new_axes() -> None:
    zones = [(4.5, 4.8), (5.2, 5.6)]
    axes = plotting.growth_rates(SPEEDS, REFERENCE, CURVES, zones, xlabel="Ω (rad/s)")
    assert isinstance(axes, Axes)
    assert axes.get_xlabel() == "Ω (rad/s)"
    assert axes.get_ylabel() == "growth rate (1/s)"
    lines = {line.get_label(): line for line in axes.get_lines()}
    assert set(lines) == {*CURVES, "Floquet"}
    np.testing.assert_array_equal(lines["order 3"].get_ydata(), CURVES["order 3"])
    np.testing.assert_array_equal(lines["Floquet"].get_xdata(), REFERENCE[0])
    styles = {(line.get_color(), line.get_linestyle()) for line in axes.get_lines()}
    assert len(styles) == len(CURVES) + 1
    texts = [text.get_text() for text in axes.get_legend().get_texts()]
    assert texts.count("unstable (Floquet)") == 1
    assert axes.get_xlim() == (4.0, 6.0)
    # Zero growth is in sight, and so is what is drawn later.
    assert axes.get_ylim()[0] < 0
    plotting.growth_rates(SPEEDS, REFERENCE, {"fast": 9 + SPEEDS}, axes=axes)
    assert axes.get_ylim()[1] > 15
    spans = [patch.get_extents().transformed(axes.transData.inverted()) for patch in axes.patches]
    # transformed to pixels and back, which rounds
    np.testing.assert_allclose([(s.x0, s.x1) for s in spans], zones, rtol=1e-12)


def test_convergence_on_new_axes() -> None:
    axes = plotting.convergence([certificate(1), certificate(2, "none")])
    points, slopes = axes.get_lines()[::2], axes.get_lines()[1::2]
    assert [p.get_label() for p in points] == [
        r"$\Omega = 2 \omega$, order 1: $\varepsilon^{2.00}$",
        r"non-resonant, order 2: $\varepsilon^{3.00}$",
    ]
    legend = [text.get_text() for text in axes.get_legend().get_texts()]
    assert legend == [*(p.get_label() for p in points), "exponent of the theory"]
    axes.figure.draw_without_rendering()
    assert axes.get_legend().get_window_extent().y0 >= axes.get_window_extent().y1
    assert points[0].get_color() != points[1].get_color()
    assert points[0].get_marker() != points[1].get_marker()
    for order, line in zip((1, 2), slopes, strict=True):
        x, y = (np.log(line.get_xdata()), np.log(line.get_ydata()))
        # a straight line through rounded logarithms
        np.testing.assert_allclose(np.diff(y) / np.diff(x), order + 1, rtol=1e-12)
    # what the reference does not resolve is not drawn
    assert len(points[1].get_xdata()) == sum(certificate(2).fits[0].resolved) < 12


def test_convergence_of_another_quantity_with_labels() -> None:
    axes = plotting.convergence([certificate(1)], ["mine"], quantity="edges of the zone")
    assert axes.get_lines()[0].get_label() == r"mine: $\varepsilon^{2.00}$"
    assert axes.get_lines()[0].get_ydata()[0] == 0.5 * EPSILONS[0] ** 2
    assert axes.get_ylabel() == "error of the edges of the zone (rad/s)"


def test_relations_are_typeset() -> None:
    """With every name that a relation can hold, in what Matplotlib understands."""
    relation = "2*Omega = omega_x + 3*omega_phi, nu = omega_1/2"
    axes = plotting.convergence([certificate(2, relation)])
    label = axes.get_lines()[0].get_label()
    assert r"$2 \Omega = \omega_{x} + 3 \omega_{\phi}, \nu = \omega_{1}/2$, order 2" in label
    axes.figure.canvas.draw()


def test_an_order_has_the_same_colour_in_all_figures() -> None:
    (line, _) = plotting.convergence([certificate(2)]).get_lines()
    drawn = plotting.growth_rates(SPEEDS, REFERENCE, {k: SPEEDS for k in ("order 1", "order 2")})
    assert line.get_color() == drawn.get_lines()[1].get_color() == plotting.COLOURS[1]


def test_no_fit_of_the_quantity() -> None:
    assert plotting.convergence([certificate(1)], quantity="nothing").get_legend() is None


def test_given_axes_leave_no_state_behind() -> None:
    settings = dict(matplotlib.rcParams)
    figure = Figure()
    for axes, drawn in (
        (
            figure.add_subplot(121),
            lambda a: plotting.growth_rates(SPEEDS, REFERENCE, CURVES, axes=a),
        ),
        (figure.add_subplot(122), lambda a: plotting.convergence([certificate(1)], axes=a)),
    ):
        assert drawn(axes) is axes
    assert plt.get_fignums() == []
    assert dict(matplotlib.rcParams) == settings


def test_no_display_is_needed() -> None:
    code = (
        "import numpy as np\n"
        "from mmsgen import plotting\n"
        "s = np.linspace(1, 2, 5)\n"
        "axes = plotting.growth_rates(s, (s, s), {'order 1': s})\n"
        "axes.figure.canvas.draw()\n"
    )
    environment = {
        k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY", "MPLBACKEND")
    }
    done = subprocess.run(
        [sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    ("smallest", "quantity", "base", "unit"),
    [
        (2.0**-8, "motions", 2, False),
        (2.0**-14, "characteristic exponents", 10, True),
        (2.0**-14, "stability", 10, True),
        (2.0**-14, "equilibrium amplitudes", 10, False),
    ],
)
def test_axis_of_epsilon_and_unit_of_the_error(
    smallest: float, quantity: str, base: int, unit: bool
) -> None:
    """Few decades are labelled by powers of two; units of coordinates are not known."""
    epsilons = tuple(smallest * 2.0**k for k in range(5 if base == 2 else 12))
    errors = tuple(e**2 for e in epsilons)
    fit = Fit(quantity, 2, epsilons, errors, (0.0,) * len(epsilons), 2.0, limit=0.0)
    axes = plotting.convergence([Certificate("none", 2, (), (fit,))], quantity=quantity)
    assert axes.xaxis.get_transform().base == base
    assert ("(1/s)" in axes.get_ylabel()) is unit
