"""Emissions: which files, the same bytes on every machine, and only cases that hold."""

from __future__ import annotations

import functools
import hashlib
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
from small_project import DERIVATION, EMITTED, SHARED, WRONG, contents
from systems import d, t, x

import mmsgen as mg
from mmsgen import emission as emitting
from mmsgen.emission import KEPT, STAGE
from mmsgen.expansion import Expansion
from mmsgen.loading import load, load_files

omega, f, Omega = sp.symbols("omega f Omega", positive=True)
FILES = [name.removeprefix("generated/") for name in EMITTED]
VALUES = {"omega": 2.3, "f": 4.9, "Omega": 3.1}


@functools.cache
def cases() -> tuple[Expansion, ...]:
    left = d(x, 2) + (omega**2 + f * sp.cos(Omega * t)) * x
    parameters = [mg.Parameter(s, "1") for s in (omega, f, Omega)]
    eom = mg.Model.from_equations([left], [x], parameters).equations_of_motion()
    scaled = eom.scale({f: 1})
    return scaled.expand(1), scaled.expand(2)


def emission(**changes: Any) -> mg.Emission:
    given = {"model": "pendulum", "cases": cases(), "samples": lambda case: VALUES, **changes}
    return mg.Emission(**given)


@pytest.fixture(autouse=True)
def no_pipeline(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(STAGE, raising=False)
    monkeypatch.delenv(KEPT, raising=False)


def spoil(
    monkeypatch: pytest.MonkeyPatch, names: set[str], factor: complex, shift: complex = 0
) -> None:
    """Make one coefficient of some emitted modules wrong, before they are certified."""

    def wrong(files: dict[str, str], wanted: list[str]) -> dict[str, Any]:
        modules = load_files(files, wanted)
        for name in names:
            matrix = modules[name].slow_flow_matrix
            changed = functools.wraps(matrix)(lambda m=matrix, **v: factor * m(**v) + shift)
            modules[name].slow_flow_matrix = changed
        return modules

    monkeypatch.setattr(emitting, "load_files", wrong)


# --- what is emitted ------------------------------------------------------------------------------


def test_files_of_cases_that_hold() -> None:
    whole = emission()
    files = whole.files()
    assert list(files) == FILES
    assert whole.failures == ()
    assert whole.held == cases()
    assert [c.order for c in whole.certificates.values()] == [1, 2]
    for name, certificate in whole.certificates.items():
        path = f"mms_functions/pendulum/{name}.certificate.json"
        assert files[path] == certificate.to_json()
        assert json.loads(files[path])["passed"] is True


def test_a_case_that_fails_is_left_out_and_the_others_are_not(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    spoil(monkeypatch, {"nonresonant_order_2"}, 1.01)
    partly = emission()
    files = partly.files()
    assert list(files) == [name for name in FILES if "order_2" not in name]
    assert "order_2" not in files["mms_functions/pendulum/__init__.py"]
    (failure,) = partly.failures
    assert failure.startswith(
        "characteristic exponents of the case without resonance at order 2: the error falls like ε^"
    )
    assert partly.held == cases()[:1]
    assert mg.publish(partly).splitlines() == [
        "4 files for pendulum, 1 cases",
        f"not emitted: {failure}",
    ]


def test_a_case_that_cannot_be_certified_is_left_out_by_name() -> None:
    weak = {**VALUES, "f": 1e-3}
    partly = emission(samples=lambda case: weak if case.order == 2 else VALUES)
    assert list(partly.certificates) == ["nonresonant_order_1"]
    (failure,) = partly.failures
    assert failure.startswith("without resonance at order 2: only 0 of 16 errors of the charact")
    assert not any("order_2" in name for name in partly.files())


def test_nothing_is_emitted_where_no_case_holds(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    spoil(monkeypatch, {"nonresonant_order_1", "nonresonant_order_2"}, 1, shift=0.01j)
    monkeypatch.setenv(STAGE, str(tmp_path))
    with pytest.raises(mg.CertificateError, match=r"no case .* order 1: .*; .* order 2: "):
        mg.publish(emission())
    assert list(tmp_path.iterdir()) == []


def test_values_that_are_wrong_are_the_users_error_not_a_failing_case() -> None:
    with pytest.raises(mg.MmsgenError, match="gamma is not a parameter") as info:
        emission(samples=lambda case: {**VALUES, "gamma": 1.0}).files()
    assert not isinstance(info.value, mg.CertificateError)


def test_model_names_that_cannot_be_imported() -> None:
    with pytest.raises(mg.EmissionError, match="cannot be imported"):
        emission(model="ground resonance").files()


def test_the_same_case_twice() -> None:
    with pytest.raises(mg.EmissionError, match="two cases are called nonresonant_order_1"):
        emission(cases=cases()[:1] * 2).files()


# --- handing over ---------------------------------------------------------------------------------


class Figure:
    """Stands for one of Matplotlib's."""

    def savefig(self, path: Path, **kwargs: Any) -> None:
        assert kwargs["metadata"] == {"Software": None}
        Path(path).write_bytes(b"picture")


def test_publish_without_a_pipeline_writes_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert mg.publish(emission(), {"name": Figure()}) == ("7 files for pendulum, 2 cases")
    assert list(tmp_path.iterdir()) == []


def test_publish_to_a_pipeline(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(STAGE, str(tmp_path))
    whole = emission()
    mg.publish(whole, {"name": Figure()})
    assert set(contents(tmp_path)) == {"emission.json", "name.png"}
    staged = json.loads((tmp_path / "emission.json").read_text("utf-8"))
    assert staged == {"files": whole.files(), "failures": []}


def test_figures_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A derivation may show what others emit."""
    monkeypatch.setenv(STAGE, str(tmp_path))
    shown = mg.publish(figures={"name": Figure()})
    assert shown == "nothing is emitted; figures: name"
    assert set(contents(tmp_path)) == {"emission.json", "name.png"}
    staged = json.loads((tmp_path / "emission.json").read_text("utf-8"))
    assert staged == {"files": {}, "failures": []}


def test_certificates_are_kept_until_something_changes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(KEPT, str(tmp_path))
    made = []

    def counted(case: Expansion, *args: Any, **kwargs: Any) -> mg.Certificate:
        made.append(case.order)
        return mg.certify(case, *args, **kwargs)

    monkeypatch.setattr(emitting, "certify", counted)
    first = emission().certificates
    assert made == [1, 2]
    assert emission().certificates == first
    assert made == [1, 2]
    # another value; the other case is as before
    emission(samples=lambda case: VALUES if case.order == 1 else {**VALUES, "f": 4.8}).files()
    assert made == [1, 2, 2]


def test_kept_certificates_follow_the_exact_equations(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Another term of order 2 changes what order 1 is compared with, and not its functions."""
    monkeypatch.setenv(KEPT, str(tmp_path))
    certificates = []
    for extra in (0, 1):
        left = d(x, 2) + (omega**2 + f * sp.cos(Omega * t) + extra * f**2) * x
        parameters = [mg.Parameter(s, "1") for s in (omega, f, Omega)]
        eom = mg.Model.from_equations([left], [x], parameters).equations_of_motion()
        case = eom.scale({f: 1}).expand(1)
        record = emission(cases=[case])
        certificates.append(record.certificates["nonresonant_order_1"].fits[0].errors)
        text = record.files()["mms_functions/pendulum/nonresonant_order_1.py"]
        certificates.append(hashlib.sha256(text.encode()).hexdigest())
    assert certificates[1] == certificates[3]
    assert certificates[0] != certificates[2]


# --- the same bytes -------------------------------------------------------------------------------


def test_bytes_do_not_depend_on_the_hash_seed(tmp_path: Path) -> None:
    (tmp_path / "shared.py").write_text(SHARED, encoding="utf-8")
    code = "".join(line for line in DERIVATION.splitlines(keepends=True) if "%%" not in line)
    (tmp_path / "script.py").write_text(code, encoding="utf-8")
    running = []
    for seed in ("0", "1", "4242"):
        stage = tmp_path / seed
        stage.mkdir()
        environment = {**os.environ, "PYTHONHASHSEED": seed, STAGE: str(stage), KEPT: ""}
        running.append(
            subprocess.Popen(
                [sys.executable, str(tmp_path / "script.py")],
                env=environment,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
            )
        )
    outputs = [process.communicate() for process in running]
    assert [process.returncode for process in running] == [0, 0, 0], outputs[0][1].decode()
    assert len({output for output, _ in outputs}) == 1
    texts = [(tmp_path / seed / "emission.json").read_bytes() for seed in ("0", "1", "4242")]
    assert len(set(texts)) == 1
    assert list(json.loads(texts[0])["files"]) == FILES


def test_the_wrong_cell_of_the_small_project_is_what_it_says() -> None:
    assert "1.01" in WRONG
    assert WRONG.startswith("# %%\n")


# --- loading --------------------------------------------------------------------------------------


@pytest.mark.filterwarnings("ignore:outside of the validity:UserWarning")
def test_loaded_modules_shadow_nothing() -> None:
    import mms_functions

    path, modules, held = list(sys.path), set(sys.modules), set(vars(mms_functions))
    first, second = (load(case) for case in cases())
    assert (first.ORDER, second.ORDER) == (1, 2)
    again = load(cases()[0])
    assert again is not first
    assert sys.path == path
    assert set(sys.modules) == modules
    assert sys.modules["mms_functions"] is mms_functions
    assert set(vars(mms_functions)) == held
    # they work although their files are gone
    assert not Path(first.__file__).exists()
    assert first.growth_rate() == 0.0
    assert first.response(0.0, [0.0], **dict.fromkeys(first.PARAMETERS, 1.5)).shape == (1,)


def test_loading_leaves_nothing_behind_when_it_fails() -> None:
    path, modules = list(sys.path), set(sys.modules)
    files = {"p/__init__.py": "", "p/m/__init__.py": "", "p/m/case.py": "raise OSError('no')\n"}
    with pytest.raises(OSError, match="no"):
        load_files(files, ["case"])
    assert sys.path == path
    assert set(sys.modules) == modules
