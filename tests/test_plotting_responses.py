"""What the figures of stability, responses and motions hold."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from entries import emitted

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")

from matplotlib.figure import Figure  # noqa: E402

from mmsgen import plotting  # noqa: E402
from mmsgen.errors import MmsgenError  # noqa: E402
from mmsgen.floquet import Chart, GrowthRate  # noqa: E402
from mmsgen.runtime._records import Bifurcation, Branch, Response  # noqa: E402


def new_axes() -> Any:
    return Figure().add_subplot(111)


def lines_of(axes: Any) -> dict[str, Any]:
    return {line.get_label(): line for line in axes.get_lines()}


# --- stability charts -----------------------------------------------------------------------------


def chart() -> Chart:
    x, y = np.linspace(1.0, 3.0, 5), np.linspace(0.0, 1.0, 3)
    value = y[:, None] - np.abs(x - 2.0)
    verdict = np.where(value > 0.1, "unstable", np.where(value < -0.1, "stable", "undecided"))
    rate = GrowthRate(value, np.full(value.shape, 1e-9), verdict, np.zeros(value.shape))
    return Chart("Omega", "f", x, y, rate, np.ones(value.shape, dtype=bool))


def test_stability_chart() -> None:
    f = np.array([0.0, 0.5, 1.0])
    edges = np.stack([2.0 - f, 2.0 + f], axis=-1)
    axes = plotting.stability_chart(
        chart(), {"order 1": (edges, f), "order 2": (edges + 0.1, f)}, scale=(0.5, 1.0)
    )
    shading = axes.collections[0]
    shown = np.ma.masked_invalid(shading.get_array())
    assert np.array_equal(~np.ma.getmaskarray(shown), chart().growth.verdict == "unstable")
    lines = lines_of(axes)
    # Both edges of a zone, the second one without an entry of its own in the legend.
    assert [text.get_text() for text in axes.get_legend().get_texts()] == [
        "unstable (Floquet)",
        "order 1",
        "order 2",
        "undecided (Floquet)",
    ]
    assert np.array_equal(lines["order 1"].get_xdata(), 0.5 * edges[:, 0])
    assert np.array_equal(lines["order 1"].get_ydata(), f)
    assert lines["order 1"].get_color() != lines["order 2"].get_color()
    assert lines["order 1"].get_linestyle() != lines["order 2"].get_linestyle()
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("Omega", "f")
    assert axes.get_xlim() == (0.5, 1.5)
    dots = lines["undecided (Floquet)"]
    undecided = chart().growth.verdict == "undecided"
    assert len(dots.get_xdata()) == undecided.sum()


@pytest.mark.parametrize(
    ("x", "y"), [(np.ones((3, 2)), np.ones(4)), (np.ones((3, 2)), np.ones((3, 2))), (1.0, 2.0)]
)
def test_boundaries_that_do_not_belong_together(x: Any, y: Any) -> None:
    with pytest.raises(MmsgenError, match="'order 1' needs arrays of the shapes"):
        plotting.stability_chart(chart(), {"order 1": (x, y)}, axes=new_axes())


# --- responses ------------------------------------------------------------------------------------


def response() -> Response:
    sigma = np.array([0.0, 1.0, 2.0, 1.0, 2.0, 3.0])
    amplitudes = np.array([[0.5, 0.1], [0.7, 0.2], [0.9, 0.3], [0.6, 0.2], [0.4, 0.1], [0.2, 0.0]])
    growth = np.array([-1.0, -1.0, 1.0, 1.0, -1.0, -1.0])
    branch = Branch(sigma, amplitudes / 2 + 0j, np.zeros((6, 0)), growth)
    folds = tuple(
        Bifurcation("saddle-node", sigma[k], branch.amplitudes[k], np.zeros(0), 0.0) for k in (2, 3)
    )
    hopf = Bifurcation("Hopf", 0.5, np.array([0.1, 0.2j]), np.zeros(0), 1.3)
    return Response("sigma", (branch,), (*folds, hopf))


def test_frequency_response_tells_stable_from_unstable() -> None:
    points = [(0.0, [0.51, 0.11], True), (2.0, [0.61, 0.21], False)]
    axes = plotting.frequency_response(
        response(), ["x", "y"], points=points, scale=10.0, axes=new_axes()
    )
    lines = lines_of(axes)
    stable, unstable = lines["x"], lines["x, unstable"]
    assert (stable.get_linestyle(), unstable.get_linestyle()) == ("-", "--")
    assert stable.get_color() == unstable.get_color() != lines["y"].get_color()
    # Together they cover every segment of the branch, each of them once.
    covered = []
    for line in (stable, unstable):
        x = line.get_xdata()
        covered += [k for k in range(5) if np.isfinite(x[k : k + 2]).all()]
        assert np.array_equal(
            x[np.isfinite(x)], 10 * response().branches[0].parameter[np.isfinite(x)]
        )
    assert sorted(covered) == [0, 1, 2, 3, 4]
    y = unstable.get_ydata()
    assert y[np.isfinite(y)].tolist() == pytest.approx([0.9, 0.6, 0.4])
    fold, hopf = lines["saddle-node"], lines["Hopf"]
    assert fold.get_marker() != hopf.get_marker()
    assert fold.get_xdata().tolist() == [20.0, 20.0, 10.0, 10.0]
    assert hopf.get_ydata().tolist() == pytest.approx([0.2, 0.4])
    filled, empty = lines["periodic orbits, stable"], lines["periodic orbits, unstable"]
    assert filled.get_markerfacecolor() == "black" and empty.get_markerfacecolor() == "none"
    assert filled.get_xydata().tolist() == [[0.0, 0.51]]
    assert axes.get_xlabel() == "sigma"
    orbits = {filled.get_marker(), empty.get_marker(), *plotting.MARKERS}
    assert not orbits & {fold.get_marker(), hopf.get_marker()}


def test_ordinates_reach_zero_and_whatever_comes_later() -> None:
    low = response()._replace(bifurcations=())
    axes = plotting.frequency_response(low, ["x", None], axes=new_axes())
    assert axes.get_ylim()[0] < 0 < 0.9 < axes.get_ylim()[1] < 1
    (branch,) = low.branches
    high = low._replace(branches=(branch._replace(amplitudes=3 * branch.amplitudes),))
    plotting.frequency_response(high, ["x", None], axes=axes)
    assert axes.get_ylim()[0] < 0 and 2.7 < axes.get_ylim()[1] < 3


def test_responses_of_two_orders_share_axes() -> None:
    axes = plotting.frequency_response(response(), ["order 1", None], axes=new_axes())
    plotting.frequency_response(response(), ["order 2", None], colour=1, axes=axes)
    lines = lines_of(axes)
    assert lines["order 1"].get_color() != lines["order 2"].get_color()
    # Apart in grey, and the first one in sight below the second.
    assert lines["order 1"].get_linewidth() > 1.5 * lines["order 2"].get_linewidth()
    shown = [text.get_text() for text in axes.get_legend().get_texts()]
    assert len(shown) == len(set(shown)) == 6
    assert {"saddle-node", "Hopf"} < set(shown)


def test_coordinates_can_be_left_out() -> None:
    axes = plotting.frequency_response(response(), [None, "y"], axes=new_axes())
    lines = lines_of(axes)
    assert "y" in lines and not any(str(label).startswith("a_1") for label in lines)
    assert lines["Hopf"].get_ydata().tolist() == pytest.approx([0.4])
    with pytest.raises(MmsgenError, match="3 names are given for 2 coordinates"):
        plotting.frequency_response(response(), ["x", "y", "z"], axes=new_axes())


def test_a_response_without_branches() -> None:
    empty = Response("sigma", (), ())
    axes = plotting.frequency_response(empty, points=[(1.0, 0.4, True)], axes=new_axes())
    assert lines_of(axes)["periodic orbits, stable"].get_xydata().tolist() == [[1.0, 0.4]]
    plotting.frequency_response(empty, axes=new_axes())


def test_backbone_goes_into_a_response() -> None:
    axes = plotting.frequency_response(response(), axes=new_axes())
    a = np.linspace(0, 1, 5)
    curves = {"order 1": (a**2, a), "order 2": (a**2 - a**4, a)}
    assert plotting.backbone(curves, (a**2, a), axes=axes) is axes
    lines = lines_of(axes)
    assert lines["order 1"].get_color() == "black"
    assert np.array_equal(lines["order 2"].get_xdata(), a**2 - a**4)
    assert lines["periodic motions"].get_linestyle() == "None"
    assert axes.get_xlabel() == "sigma"
    own = plotting.backbone(curves, axes=new_axes())
    assert own.get_xlabel() == "detuning (rad/s)"


def test_what_emitted_functions_return_is_drawn() -> None:
    """Their records are those of the emitted package, not of this one."""
    primary = emitted("duffing_forced", "Omega_is_omega_0_order_2")
    values = {"omega_0": 1.0, "alpha": 0.1, "mu": 0.02, "K": 0.05}
    found = primary.frequency_response(sigma=np.linspace(-0.1, 0.15, 61), **values)
    assert not isinstance(found, Response)
    axes = plotting.frequency_response(found, ["order 2"], axes=new_axes())
    a = np.linspace(0, 1.3, 14)
    plotting.backbone({"backbone": (primary.backbone(a, **values), a)}, axes=axes)
    shown = [text.get_text() for text in axes.get_legend().get_texts()]
    assert shown == ["order 2", "order 2, unstable", "backbone", "saddle-node"]


# --- legends -------------------------------------------------------------------------------------


def test_panels_share_a_legend() -> None:
    figure = Figure(layout="constrained")
    left, right = panels = figure.subplots(1, 2)
    points = [(0.0, [0.51], True)]
    only = Response("sigma", response().branches, ())
    plotting.frequency_response(response(), ["order 1", None], points=points, axes=left)
    plotting.frequency_response(only, ["order 1", None], axes=right)
    plotting.frequency_response(only, ["order 2", None], colour=1, axes=right)
    legend = plotting.shared_legend(panels, 3)
    assert left.get_legend() is None and right.get_legend() is None
    # Lines first, then markers.
    assert [text.get_text() for text in legend.get_texts()] == [
        "order 1",
        "order 1, unstable",
        "order 2",
        "order 2, unstable",
        "saddle-node",
        "Hopf",
        "periodic orbits, stable",
    ]
    figure.draw_without_rendering()
    below = legend.get_window_extent()
    assert all(below.y1 <= axes.get_tightbbox().y0 for axes in panels)
    with pytest.raises(MmsgenError, match="at least one panel"):
        plotting.shared_legend([])


# --- motions --------------------------------------------------------------------------------------


def test_time_response_with_envelope() -> None:
    t = np.linspace(0.0, 10.0, 101)
    a = np.exp(-t / 5)
    signals = {"exact": a * np.cos(9 * t), "slow flow": a * np.cos(9.01 * t)}
    axes = plotting.time_response(t, signals, {"envelope": a}, ylabel="x (m)", axes=new_axes())
    lines = lines_of(axes)
    assert list(lines) == ["exact", "slow flow", "envelope"]
    assert lines["exact"].get_linewidth() > lines["slow flow"].get_linewidth()
    assert np.array_equal(lines["slow flow"].get_ydata(), signals["slow flow"])
    y = lines["envelope"].get_ydata()
    assert np.array_equal(y[:101], a) and np.array_equal(y[102:], -a) and np.isnan(y[101])
    assert axes.get_xlim() == (0.0, 10.0)
    flat = plotting.time_response(t, {"x": a}, {"limit cycle": 0.5}, axes=new_axes())
    assert np.nanmin(lines_of(flat)["limit cycle"].get_ydata()) == -0.5


def test_time_response_names_what_does_not_fit() -> None:
    t = np.linspace(0.0, 1.0, 5)
    with pytest.raises(MmsgenError, match=r"'x' has the shape \(4,\), the times have \(5,\)"):
        plotting.time_response(t, {"x": t[1:]}, axes=new_axes())
    with pytest.raises(MmsgenError, match="envelope 'a' has the shape"):
        plotting.time_response(t, {"x": t}, {"a": t[1:]}, axes=new_axes())
    with pytest.raises(MmsgenError, match="times must be an array"):
        plotting.time_response(1.0, {"x": t}, axes=new_axes())
