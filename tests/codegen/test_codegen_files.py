"""The emitted files: names, determinism, lint, imports, and what an interruption leaves."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from importlib import import_module
from inspect import signature
from pathlib import Path

import pytest
import sympy as sp
from codegen_systems import BOTH, CASES, Omega, _scaled, emitted, f, omega, parameters, q, t

from mmsgen.codegen import case_name, emission, generate, render
from mmsgen.codegen.case_module import fill
from mmsgen.codegen.kernels import SHARED
from mmsgen.codegen.model_module import _MODEL
from mmsgen.codegen.naming import case_name as name_of
from mmsgen.equations import EquationsOfMotion
from mmsgen.errors import EmissionError
from mmsgen.loading import load_files

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent


def solved(order: int = 1) -> object:
    return _scaled("mathieu").expand(order=order, resonance={Omega: 2 * omega})


def test_names_of_cases() -> None:
    assert case_name(emitted("rotor").case) == "Omega_is_omega_x_plus_omega_phi_order_1"
    assert case_name(emitted("stable").case) == "Omega_is_omega_phi_minus_omega_x_order_1"
    assert case_name(emitted("coupled").case) == (
        "Omega_is_omega_x_plus_omega_phi_and_omega_y_is_omega_x_order_1"
    )
    assert case_name(emitted("plain").case) == "nonresonant_order_1"
    assert case_name(emitted("mathieu").case) == "Omega_is_two_omega_order_3"
    assert case_name(emitted("natural").case) == "two_omega_is_Omega_order_1"
    assert case_name(emitted("numeric").case) == "Omega_is_two_order_2"
    assert name_of is case_name


def test_files_and_table(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    cases = [emitted("rotor").case, emitted("coupled").case, emitted("plain").case]
    files = render(cases, model="rotor", derivation="derivations/rotor.py", source="a book")
    names = [case_name(c) for c in cases]
    expected = {f"mms_functions/{n}.py" for n in ("__init__", *SHARED)}
    expected |= {f"mms_functions/rotor/{n}.py" for n in ("__init__", *names)}
    assert set(files) == expected | {f"mms_functions/rotor/{n}.reference.json" for n in names}
    for name in names:
        text = files[f"mms_functions/rotor/{name}.py"]
        assert "derivations/rotor.py" in text.split("\n")[0]
        assert "a book" in text
        stored = json.loads(files[f"mms_functions/rotor/{name}.reference.json"])
        assert stored["sha256"] in text
    generate(cases, directory=tmp_path, package="emitted_here", model="rotor")
    monkeypatch.syspath_prepend(tmp_path)
    module = import_module("emitted_here.rotor")
    assert list(module.CASES) == names
    entry = module.CASES[names[0]]
    assert entry["relation"] == "Omega = omega_x + omega_phi + sigma"
    assert entry["kind"] == "sum combination"
    assert entry["coordinates"] == ("x", "phi_1", "phi_2", "phi_3", "phi_4")
    assert entry["order"] == 1
    assert entry["unstable"] is True
    assert "discriminant" in entry["reason"]
    assert module.CASES[names[1]]["kind"] == "sum combination and internal 1:1"
    assert module.CASES[names[2]]["unstable"] is False


def test_same_bytes_whatever_the_hash_seed() -> None:
    code = (
        "import hashlib, json\n"
        "from codegen_systems import emitted\n"
        "files = {n: dict(emitted(n).files) for n in ('coupled', 'pair', 'mathieu', 'duffing')}\n"
        "print(hashlib.sha256(json.dumps(files, sort_keys=True).encode()).hexdigest())"
    )
    path = os.pathsep.join([str(HERE), os.environ.get("PYTHONPATH", "")])
    running = [
        subprocess.Popen(
            [sys.executable, "-c", code],
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": path},
            stdout=subprocess.PIPE,
            text=True,
        )
        for seed in ("1", "4242")
    ]
    outputs = [process.communicate()[0] for process in running]
    assert all(process.returncode == 0 for process in running)
    assert len(set(outputs)) == 1
    assert len(outputs[0].strip()) == 64


def test_no_path_and_no_time_stamp(tmp_path: Path) -> None:
    here = tmp_path / "derivations" / "mine.py"
    for text in render(solved(), model="m", derivation=here).values():  # type: ignore[arg-type]
        assert str(tmp_path) not in text
        assert str(Path.home()) not in text
    header = render(solved(), model="m", derivation=here)  # type: ignore[arg-type]
    assert "from mine.py:" in header["mms_functions/m/Omega_is_two_omega_order_1.py"]


@pytest.mark.pinned
def test_emitted_code_passes_ruff(tmp_path: Path) -> None:
    for name in CASES:
        generate(emitted(name).case, directory=tmp_path, model=f"m_{name}")
    generate(_hostile(), directory=tmp_path, model="hostile")
    config = str(ROOT / "pyproject.toml")
    done = subprocess.run(
        [sys.executable, "-m", "ruff", "check", "--no-cache", "--config", config, str(tmp_path)],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout


def test_every_function_says_what_it_takes_and_gives() -> None:
    for name in ("rotor", "coupled", "damped2", "duffing"):
        module = emitted(name).module
        functions = [getattr(module, n) for n in module.__all__ if n.islower()]
        for function in functions:
            document = function.__doc__ or ""
            for keyword, one in signature(function).parameters.items():
                kind = "array_like" if one.default is one.empty else ""
                assert f"    {keyword} : {kind}" in document
            assert "Returns\n    -------" in document
            assert "Raises\n    ------" in document
        assert module.RELATIONS == () or module.RELATIONS[0] in (module.__doc__ or "")


# --- names that get in the way --------------------------------------------------------------------


def _hostile() -> object:
    names = "np x0 evaluate growing out checked arguments PARAMETERS amplitudes lower"
    first, second, *rest = sp.symbols(names, positive=True)
    drive = sp.Mul(*rest)
    force = second * q.diff(t) + (first**2 + 2 * f * drive * sp.cos(Omega * t)) * q
    known = parameters(first, second, f, *rest, Omega)
    scaled = EquationsOfMotion((q.diff(t, 2) + force,), (q,), known).scale({f: 1, second: 1})
    return scaled.expand(order=1, resonance={Omega: 2 * first})


def test_parameters_may_have_any_name() -> None:
    case = _hostile()
    files = render(case, model="hostile")  # type: ignore[arg-type]
    (module,) = load_files(files, [case_name(case)]).values()  # type: ignore[arg-type]
    ones = dict.fromkeys(
        (
            "evaluate",
            "growing",
            "out",
            "checked",
            "arguments",
            "PARAMETERS",
            "amplitudes",
            "lower",
        ),
        1.0,
    )
    plain = emitted("damped").module
    rate = module.growth_rate(sigma=0.05, f=0.2, np=1.5, x0=0.06, **ones)
    # x0 multiplies the velocity, as 2μ does.
    assert rate == pytest.approx(
        plain.growth_rate(sigma=0.05, omega=1.5, f=0.2, mu=0.03), rel=1e-14
    )
    edges = module.boundaries(f=0.2, np=1.5, x0=0.06, **ones)
    assert edges == pytest.approx(plain.boundaries(omega=1.5, f=0.2, mu=0.03), rel=1e-14)
    own = module.slow_flow([1 + 2j], sigma=0.05, f=0.2, np=1.5, x0=0.06, **ones)
    assert own == pytest.approx(
        plain.slow_flow([1 + 2j], sigma=0.05, omega=1.5, f=0.2, mu=0.03), rel=1e-14
    )
    with pytest.raises(ValueError, match=r"^np must be positive"):
        module.growth_rate(sigma=0.05, f=0.2, np=-1.5, x0=0.06, **ones)


# --- what is refused ------------------------------------------------------------------------------


def test_the_same_case_twice() -> None:
    with pytest.raises(EmissionError, match="Omega_is_two_omega_order_1"):
        render([solved(), solved()])  # type: ignore[list-item]


@pytest.mark.parametrize(
    "wrong", [{"package": "mms-functions"}, {"model": "class"}, {"model": "_m"}, {"package": ""}]
)
def test_names_that_cannot_be_imported(wrong: dict[str, str]) -> None:
    with pytest.raises(EmissionError, match="cannot be imported"):
        render(solved(), **wrong)  # type: ignore[arg-type]


def test_nothing_to_emit() -> None:
    with pytest.raises(EmissionError, match="at least one case"):
        render([])
    with pytest.raises(EmissionError, match="not a solved case"):
        render([_scaled("mathieu")])


def test_a_template_and_its_keys_name_the_same_things() -> None:
    with pytest.raises(EmissionError, match="'origin'"):
        fill(_MODEL, {})
    with pytest.raises(EmissionError, match="'more'"):
        fill(_MODEL, {**dict.fromkeys(_MODEL.get_identifiers(), ""), "more": ""})


# --- writing --------------------------------------------------------------------------------------


def tree(folder: Path) -> dict[str, bytes]:
    return {
        p.relative_to(folder).as_posix(): p.read_bytes() for p in folder.rglob("*") if p.is_file()
    }


def test_what_is_written_is_what_is_rendered(tmp_path: Path) -> None:
    paths = generate(solved(), directory=tmp_path, model="m")  # type: ignore[arg-type]
    files = render(solved(), model="m")  # type: ignore[arg-type]
    assert tree(tmp_path) == {k: v.encode() for k, v in files.items()}
    stamps = {p: p.stat().st_mtime_ns for p in paths}
    again = generate(solved(), directory=tmp_path, model="m")  # type: ignore[arg-type]
    assert {p: p.stat().st_mtime_ns for p in again} == {p: stamps[p] for p in again}
    (tmp_path / "mms_functions" / "__init__.py").write_text('"""Mine."""\n')
    generate(solved(), directory=tmp_path, model="m")  # type: ignore[arg-type]
    assert (tmp_path / "mms_functions" / "__init__.py").read_text() == '"""Mine."""\n'


def test_comparing_only(tmp_path: Path) -> None:
    with pytest.raises(EmissionError, match=r"Omega_is_two_omega_order_1\.py"):
        generate(solved(), directory=tmp_path, model="m", update=False)  # type: ignore[arg-type]
    assert not tree(tmp_path)
    generate(solved(), directory=tmp_path, model="m")  # type: ignore[arg-type]
    generate(solved(), directory=tmp_path, model="m", update=False)  # type: ignore[arg-type]
    case = tmp_path / "mms_functions" / "m" / "Omega_is_two_omega_order_1.py"
    case.write_text(case.read_text() + "\n")
    with pytest.raises(EmissionError, match=case.name):
        generate(solved(), directory=tmp_path, model="m", update=False)  # type: ignore[arg-type]


def test_stale_cases_go_only_when_asked(tmp_path: Path) -> None:
    generate([solved(1), solved(2)], directory=tmp_path, model="m")  # type: ignore[list-item]
    generate(solved(1), directory=tmp_path, model="m")  # type: ignore[arg-type]
    folder = tmp_path / "mms_functions" / "m"
    mine = folder / "notes.py"
    mine.write_text("")
    assert (folder / "Omega_is_two_omega_order_2.py").exists()
    generate(solved(1), directory=tmp_path, model="m", prune=True)  # type: ignore[arg-type]
    left = sorted(p.name for p in folder.iterdir())
    assert left == [
        "Omega_is_two_omega_order_1.py",
        "Omega_is_two_omega_order_1.reference.json",
        "__init__.py",
        "notes.py",
    ]


def test_nothing_is_written_when_a_case_fails(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: object) -> str:
        raise EmissionError("no")

    monkeypatch.setattr(emission, "reference_text", fail)
    with pytest.raises(EmissionError):
        generate(solved(), directory=tmp_path, model="m")  # type: ignore[arg-type]
    assert not tree(tmp_path)


def test_an_interruption_leaves_whole_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    files = render(solved(), model="m")  # type: ignore[arg-type]
    replace, done = Path.replace, []

    def interrupted(self: Path, target: Path) -> Path:
        if len(done) == 3:
            raise KeyboardInterrupt
        done.append(target)
        return replace(self, target)

    monkeypatch.setattr(Path, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        generate(solved(), directory=tmp_path, model="m")  # type: ignore[arg-type]
    left = tree(tmp_path)
    assert len(left) == 3
    assert all(files[path].encode() == content for path, content in left.items())
    monkeypatch.undo()
    generate(solved(), directory=tmp_path, model="m")  # type: ignore[arg-type]
    assert tree(tmp_path) == {k: v.encode() for k, v in files.items()}


# --- importing ------------------------------------------------------------------------------------


def test_import_needs_numpy_alone_and_loads_cases_when_used(tmp_path: Path) -> None:
    generate([solved(1), solved(2)], directory=tmp_path, model="m")  # type: ignore[list-item]
    code = (
        "import sys, numpy\n"
        "before = set(sys.modules)\n"
        "import mms_functions.m as m\n"
        "assert not any('order' in name for name in sys.modules), 'cases are loaded too early'\n"
        "from mms_functions.m import Omega_is_two_omega_order_1 as one\n"
        "assert m.Omega_is_two_omega_order_2.ORDER == 2\n"
        "assert one.growth_rate(sigma=0.0, omega=1.0, f=0.2) > 0\n"
        "assert set(dir(m)) == {'CASES', *m.CASES}\n"
        "try:\n    m.other\nexcept AttributeError as error:\n    assert 'other' in str(error)\n"
        "new = {n.split('.')[0] for n in set(sys.modules) - before}\n"
        "print(sorted(new - set(sys.stdlib_module_names) - {'numpy'}))"
    )
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", code],
        env={**os.environ, "PYTHONPATH": str(tmp_path)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip() == "['mms_functions']"


def test_a_model_of_several_relations_can_be_emitted(tmp_path: Path) -> None:
    case = _scaled("rotor4").expand(order=1, resonance=BOTH)
    assert len(generate(case, directory=tmp_path)) == 4 + len(SHARED)


@pytest.mark.parametrize("cases", [None, 3, emission, [3]])
def test_what_is_no_case_is_refused(cases: object, tmp_path: Path) -> None:
    with pytest.raises(EmissionError, match="is not a solved case"):
        generate(cases, directory=tmp_path)  # type: ignore[arg-type]


@pytest.mark.parametrize("name", [None, 3, "", "_a"])
def test_names_that_cannot_be_imported_are_refused(name: object, tmp_path: Path) -> None:
    for names in ({"package": name}, {"model": name}):
        with pytest.raises(EmissionError, match="cannot be imported"):
            generate(solved(), directory=tmp_path, **names)  # type: ignore[arg-type]
