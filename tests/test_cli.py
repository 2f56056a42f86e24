"""The command `mmsgen make`: exit codes and messages."""

from __future__ import annotations

import inspect
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from small_project import DERIVATION, EMITTED, WRONG, contents, small_project

pytest.importorskip("typer")
pytest.importorskip("nbclient")

from typer.testing import CliRunner, Result

from mmsgen import cli
from mmsgen.errors import MmsgenError
from mmsgen.pipeline import Outcome, Project


def runner() -> CliRunner:
    """One that keeps standard error apart: up to click 8.1 that is an option."""
    apart = "mix_stderr" in inspect.signature(CliRunner).parameters
    return CliRunner(mix_stderr=False) if apart else CliRunner()


def run(*arguments: str) -> Result:
    return runner().invoke(cli.app, ["make", *arguments], catch_exceptions=False)


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Project:
    """A project with a second derivation, in which the command is run."""
    result = small_project(tmp_path / "project")
    (result.derivations / "another.py").write_text(DERIVATION, encoding="utf-8")
    monkeypatch.chdir(result.root)
    return result


@pytest.fixture
def outcomes(monkeypatch: pytest.MonkeyPatch) -> dict[str, Outcome | Exception]:
    """What each derivation is to lead to, instead of being made."""
    table: dict[str, Outcome | Exception] = {}
    calls: list[tuple[str, bool]] = []

    def make(project: Project, name: str, *, check: bool, progress: object) -> Outcome:
        calls.append((name, check))
        outcome = table.get(name, Outcome(name, (), ()))
        if isinstance(outcome, Exception):
            raise outcome
        return outcome

    monkeypatch.setattr(cli, "make_one", make)
    table["calls"] = calls  # type: ignore[assignment]
    return table


def test_all_derivations_by_default(project: Project, outcomes: dict) -> None:
    outcomes["pendulum"] = Outcome("pendulum", ("generated/a.py", "generated/b.py"), ())
    result = run()
    assert result.exit_code == 0
    assert outcomes["calls"] == [("another", False), ("pendulum", False)]
    assert result.stdout == ""
    assert "another: 0 files changed" in result.stderr
    assert "pendulum: 2 files changed" in result.stderr
    assert "  generated/a.py\n  generated/b.py\n" in result.stderr


def test_only_those_that_are_named(project: Project, outcomes: dict) -> None:
    assert run("pendulum").exit_code == 0
    assert outcomes["calls"] == [("pendulum", False)]


def test_check(project: Project, outcomes: dict) -> None:
    assert run("--check").exit_code == 0
    assert outcomes["calls"] == [("another", True), ("pendulum", True)]
    outcomes["another"] = Outcome("another", ("generated/a.py",), ())
    result = run("--check")
    assert result.exit_code == 1
    assert "another: 1 files differ" in result.stderr
    assert "pendulum: 0 files differ" in result.stderr
    assert "the committed output differs from fresh output: run make and" in result.stderr


@pytest.mark.parametrize("options", [(), ("--check",)])
def test_a_case_that_is_not_emitted(
    project: Project, outcomes: dict, options: tuple[str, ...]
) -> None:
    """It is named with the reason, in one piece, and the other derivations are made."""
    failure = (
        "edges of Omega = 2*omega [x] at order 2: " + "the error falls like ε^1.50, " * 5 + "end"
    )
    outcomes["another"] = Outcome("another", (), (failure, "second"))
    result = run(*options)
    assert result.exit_code == 1
    assert f"mmsgen: not emitted: {failure}\n" in result.stderr
    assert "mmsgen: not emitted: second\n" in result.stderr
    assert [name for name, _ in outcomes["calls"]] == ["another", "pendulum"]


def test_errors_are_told_without_a_traceback(project: Project, outcomes: dict) -> None:
    outcomes["another"] = MmsgenError("the frequency [omega] is no frequency " + "x" * 100)
    result = run()
    assert result.exit_code == 1
    assert result.stderr.endswith(
        "mmsgen: the frequency [omega] is no frequency " + "x" * 100 + "\n"
    )
    assert "Traceback" not in result.output


def test_an_unknown_derivation_is_told_before_any_is_made(project: Project, outcomes: dict) -> None:
    result = run("pendulum", "rotor")
    assert result.exit_code == 1
    assert result.stderr == (
        "mmsgen: there is no derivation 'rotor'; known are another, pendulum\n"
    )
    assert outcomes["calls"] == []


def test_outside_a_project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    result = run()
    assert result.exit_code == 1
    assert "mmsgen: no project here: a folder with pyproject.toml" in result.stderr


def test_a_project_without_derivations(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "derivations").mkdir()
    (tmp_path / "pyproject.toml").touch()
    monkeypatch.chdir(tmp_path)
    result = run()
    assert result.exit_code == 1
    assert "mmsgen: there is no derivation in " in result.stderr


def test_bad_usage_and_help() -> None:
    own = runner()
    assert own.invoke(cli.app, ["make", "--nonsense"]).exit_code == 2
    assert own.invoke(cli.app, ["nonsense"]).exit_code == 2
    helped = own.invoke(cli.app, ["make", "--help"])
    assert helped.exit_code == 0
    assert "--check" in helped.output


def command(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "mmsgen", *arguments],
        cwd=folder,
        env={**os.environ, "COLUMNS": "80", "PYTHONIOENCODING": "utf-8"},
        capture_output=True,
        encoding="utf-8",
        check=False,
    )


def test_end_to_end_with_a_wrong_case(tmp_path: Path) -> None:
    """A real run: the wrong case is named and not emitted, the right one is, and make fails."""
    project = small_project(tmp_path / "project", WRONG + DERIVATION)
    done = command(project.root, "make")
    assert done.returncode == 1
    assert (
        "mmsgen: not emitted: characteristic exponents of the case without resonance at order 2: "
        "the error falls like ε^"
    ) in done.stderr
    assert "the theory demands ε^3" in done.stderr
    assert "Traceback" not in done.stderr
    made = contents(project.root)
    expected = {name for name in EMITTED if "order_2" not in name}
    assert {n for n in made if n.startswith("generated")} == expected
    assert b"not emitted" in made["derivations/pendulum.ipynb"]


def test_a_user_error_as_a_process(tmp_path: Path) -> None:
    done = command(tmp_path, "make")
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith("mmsgen: no project here")
    assert "Traceback" not in done.stderr


def test_a_failing_derivation_does_not_stop_the_others(project: Project, outcomes: dict) -> None:
    outcomes["another"] = MmsgenError("no case holds")
    outcomes["pendulum"] = Outcome("pendulum", (), ("case 2: wrong",))
    result = run()
    assert result.exit_code == 1
    assert [name for name, _ in outcomes["calls"]] == ["another", "pendulum"]
    assert result.stderr.splitlines()[-2:] == [
        "mmsgen: no case holds",
        "mmsgen: not emitted: case 2: wrong",
    ]


def test_a_script_that_is_not_utf_8(tmp_path: Path) -> None:
    project = small_project(tmp_path / "project")
    (project.derivations / "pendulum.py").write_bytes(b"# %%\nname = '\xe9'\n")
    done = command(project.root, "make")
    assert done.returncode == 1
    assert "mmsgen: pendulum.py is not UTF-8 text (byte 13)" in done.stderr
    assert "Traceback" not in done.stderr


def test_an_interrupt_is_one_line_and_leaves_no_kernel(tmp_path: Path) -> None:
    marker = tmp_path / "kernel"
    cell = f"""# %%
import os, pathlib, time
pathlib.Path({str(marker)!r}).write_text(str(os.getpid()))
time.sleep(60)
"""
    project = small_project(tmp_path / "project", cell)
    before = contents(project.root)
    process = subprocess.Popen(
        [sys.executable, "-m", "mmsgen", "make"],
        cwd=project.root,
        stderr=subprocess.PIPE,
        encoding="utf-8",
        start_new_session=True,
    )
    while not (marker.exists() and marker.read_text()) and process.poll() is None:
        time.sleep(0.05)
    os.killpg(process.pid, signal.SIGINT)
    _, told = process.communicate(timeout=60)
    assert process.returncode == 130
    assert told.splitlines()[-1].startswith("mmsgen: interrupted")
    assert "Traceback" not in told
    assert "Error" not in told
    assert contents(project.root) == before
    with pytest.raises(ProcessLookupError):
        os.kill(int(marker.read_text()), 0)
