"""What is committed of the derivation of ground resonance, against fresh results and references.

`make check` compares everything; here is what takes no time.
"""

from __future__ import annotations

import json
import math
import re
from decimal import Decimal
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import rotor
from latex_values import balanced

import mmsgen as mg
from mmsgen.codegen import case_name, render

ROOT = Path(__file__).resolve().parent.parent
SCRIPT = ROOT / "derivations" / "ground_resonance.py"
NOTEBOOK = SCRIPT.with_suffix(".ipynb")
EMITTED = ROOT / "generated" / "mms_functions"
CERTIFICATES = sorted(EMITTED.glob("ground_resonance/*.certificate.json"))


def scaled() -> mg.ScaledSystem:
    alike = rotor.undamped(rotor.isotropic(rotor.helicopter(4).equations_of_motion()))
    eom = rotor.at_speed(rotor.in_ratios(alike.linearise()))
    return eom.scale({rotor.r_m: 1, rotor.r_b: 1})


def notebook() -> dict[str, Any]:
    return json.loads(NOTEBOOK.read_text("utf-8"))


# --- emitted functions ----------------------------------------------------------------------------


@pytest.mark.pinned
@pytest.mark.parametrize("order", [1, 2])
def test_a_case_rendered_afresh_is_what_is_committed(order: int) -> None:
    (source,) = re.findall(r'^    source="(.*)",$', SCRIPT.read_text("utf-8"), re.MULTILINE)
    case = scaled().expand(order, {rotor.Omega: rotor.omega_x + rotor.omega_phi})
    derivation = SCRIPT.relative_to(ROOT).as_posix()
    files = render(case, model="ground_resonance", derivation=derivation, source=source)
    # the table of the model names all cases, and is compared by `make check`
    del files["mms_functions/ground_resonance/__init__.py"]
    assert f"mms_functions/ground_resonance/{case_name(case)}.py" in files
    for name, text in files.items():
        assert (EMITTED.parent / name).read_text("utf-8") == text, f"{name}: run make"


def test_only_certified_cases_are_emitted() -> None:
    modules = {p.stem for p in EMITTED.glob("ground_resonance/*_order_*.py")}
    assert modules == {p.name.removesuffix(".certificate.json") for p in CERTIFICATES}
    assert len(modules) == 17
    for path in CERTIFICATES:
        data = json.loads(path.read_text("utf-8"))
        assert data["passed"]
        assert path.name.removesuffix(".certificate.json").endswith(f"_order_{data['order']}")
        for fit in data["fits"]:
            assert fit["theory"] == data["order"] + 1
            # whole, and more where an error term vanishes: without resonance odd ones do
            exponent = float(fit["fitted"])
            assert abs(exponent - round(exponent)) < 0.1
            assert round(exponent) - fit["theory"] == (
                data["relation"] == "none" and data["order"] == 2
            )


# Edges of the zones of the isotropic rotor in Hz, by Floquet theory and by the time-invariant
# equations in multiblade coordinates, found by a program that has nothing in common with this one.
ZONES = {
    "omega_x": (4.4502080451259, 5.0320592577578),
    "omega_y": (5.4947813208074, 6.3663311352138),
}


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("frequency", list(ZONES))
def test_zones_at_the_numbers_of_the_paper(frequency: str, order: int) -> None:
    name = f"Omega_is_{frequency}_plus_omega_phi_order_{order}.certificate.json"
    data = json.loads((EMITTED / "ground_resonance" / name).read_text("utf-8"))
    (zone,) = data["zones"]
    for text, hertz in zip(zone["floquet"], ZONES[frequency], strict=True):
        exact = Decimal(2 * math.pi * hertz)
        unit = Decimal(10) ** Decimal(text).as_tuple().exponent  # type: ignore[arg-type]
        # rounded to the last digit written; the reference has more digits
        assert abs(Decimal(text) - exact) < unit * Decimal("0.51")
    # order 2 is nearer than order 1 at both ends, within two hundredths of a hertz
    if order == 2:
        emitted = [float(x) / (2 * math.pi) for x in zone["emitted"]]
        np.testing.assert_allclose(emitted, ZONES[frequency], rtol=0, atol=0.02)


def test_the_call_that_the_notebook_shows() -> None:
    from mms_functions.ground_resonance import Omega_is_omega_x_plus_omega_phi_order_2 as case

    (code,) = re.findall(
        r"^# low, high = case\.critical_speeds\((.*?)\)$",
        SCRIPT.read_text("utf-8"),
        re.MULTILINE | re.DOTALL,
    )
    pairs = re.findall(r"(\w+)=([0-9./ ]+)", code)
    values = {
        name: math.prod(1 / float(x) if k else float(x) for k, x in enumerate(v.split("/")))
        for name, v in pairs
    }
    low, high = case.critical_speeds(**values)
    # the numbers of the paper in four digits: a thousandth of the speed
    assert 2 * math.pi * 4.445 < low < 2 * math.pi * 4.455
    assert 2 * math.pi * 5.025 < high < 2 * math.pi * 5.040


def test_order_2_moves_the_centre_of_the_zone_not_its_width() -> None:
    from mms_functions.ground_resonance import (
        Omega_is_omega_x_plus_omega_phi_order_1 as first,
    )
    from mms_functions.ground_resonance import (
        Omega_is_omega_x_plus_omega_phi_order_2 as second,
    )

    changes = []
    for size in (1 / 8, 1 / 16):
        values = {"r_m": 0.05 * size, "r_b": 0.3 * size, "omega_x": 18.7, "omega_phi": 11.3}
        low, high = first.boundaries(**values)
        lower, upper = second.boundaries(**values, omega_y=25.9)
        assert low == -high
        assert abs(upper + lower) > 0.1 * size**2
        changes.append((upper - lower) / (high - low) - 1)
    # What order 2 leaves out: two orders in epsilon beside the width, and next to it two more.
    assert math.log2(changes[0] / changes[1]) == pytest.approx(2, abs=0.01)


def test_a_whirling_fuselage_widens_the_zone_by_the_root_of_two() -> None:
    relation = {rotor.Omega: rotor.omega_x + rotor.omega_phi}
    eom = scaled().eom
    alike = eom.reparametrise({rotor.omega_y: rotor.omega_x}).scale({rotor.r_m: 1, rotor.r_b: 1})
    low, high = alike.expand(1, relation).slow_flow.boundary()
    apart = scaled().expand(1, relation).slow_flow.boundary()[1]
    assert low == -high
    assert (high**2 / apart**2).cancel() == 2


# --- the notebook ---------------------------------------------------------------------------------


@pytest.mark.pinned
def test_the_notebook_is_that_of_the_script() -> None:
    jupytext = pytest.importorskip("jupytext")
    cells = jupytext.read(SCRIPT, fmt="py:percent").cells
    committed = notebook()["cells"]
    assert [c["cell_type"] for c in committed] == [c.cell_type for c in cells]
    for old, new in zip(committed, cells, strict=True):
        assert "".join(old["source"]) == new.source, "run make"


def outputs() -> list[dict[str, Any]]:
    return [o for cell in notebook()["cells"] for o in cell.get("outputs", ())]


def test_the_notebook_ran_through_and_in_silence() -> None:
    kinds = {o["output_type"] for o in outputs()}
    assert kinds <= {"display_data", "execute_result", "stream"}
    assert {o.get("name", "stdout") for o in outputs()} == {"stdout"}
    code = [c for c in notebook()["cells"] if c["cell_type"] == "code"]
    assert [c["execution_count"] for c in code] == list(range(1, len(code) + 1))
    text = NOTEBOOK.read_text("utf-8")
    assert "not emitted:" not in text
    assert not re.search(r"0x[0-9a-f]{6,}|/home/|/tmp/|/usr/|site-packages", text)


def test_every_formula_of_the_notebook_has_its_brackets() -> None:
    formulas = [
        "".join(o["data"]["text/latex"]) for o in outputs() if "text/latex" in o.get("data", {})
    ]
    assert len(formulas) > 40
    for formula in formulas:
        assert balanced(formula), formula
    markdown = [
        "".join(c["source"]) for c in notebook()["cells"] if c["cell_type"] == "markdown"
    ] + [
        "".join(o["data"]["text/markdown"])
        for o in outputs()
        if "text/markdown" in o.get("data", {})
    ]
    for text in markdown:
        plain = re.sub(r"```.*?```|`[^`]*`", "", text, flags=re.DOTALL)
        assert plain.count("$") % 2 == 0, text
        for formula in re.findall(r"\$\$(.*?)\$\$|\$(.*?)\$", plain, flags=re.DOTALL):
            assert balanced("".join(formula)), text


def test_figures_and_tables_are_there() -> None:
    kinds = [set(o.get("data", {})) for o in outputs()]
    assert sum("image/png" in k for k in kinds) == 3  # convergence, growth rate, chart
    for name in ("ground_resonance", "ground_resonance_chart"):
        assert (ROOT / "docs" / "figures" / f"{name}.png").is_file()
    assert sum("text/html" in k for k in kinds) >= 3  # resonances to order 1, to 2, and ranked
