"""`make` on a small project: what is written, what is left alone, what an interruption leaves."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from small_project import DERIVATION, EMITTED, FOLDER, contents, small_project

nbformat = pytest.importorskip("nbformat")
pytest.importorskip("nbclient")
pytest.importorskip("jupytext")

from mmsgen import pipeline  # noqa: E402
from mmsgen.emission import KEPT, STAGE  # noqa: E402
from mmsgen.errors import MmsgenError  # noqa: E402
from mmsgen.pipeline import Project, find_project, make  # noqa: E402

NOTEBOOK = "derivations/pendulum.ipynb"


def without_build(folder: Path) -> dict[str, bytes]:
    return {name: data for name, data in contents(folder).items() if not name.startswith("build/")}


def test_end_to_end(tmp_path: Path) -> None:
    """The real thing: a kernel, three times."""
    project = small_project(tmp_path / "project")
    sources = set(contents(project.root))
    outcome = make(project, "pendulum")
    assert outcome.failures == ()
    assert list(outcome.changed) == sorted([NOTEBOOK, *EMITTED])
    made = contents(project.root)
    assert {n for n in made if not n.startswith("build/")} == sources | set(outcome.changed)
    stamps = {n: (project.root / n).stat().st_mtime_ns for n in made}
    again = make(project, "pendulum")
    assert again.changed == again.failures == ()
    assert contents(project.root) == made
    assert {n: (project.root / n).stat().st_mtime_ns for n in made} == stamps
    # nothing that is kept may be part of a comparison
    for kept in (project.root / "build" / "certificates").iterdir():
        kept.write_text("{}", encoding="utf-8")
    made = contents(project.root)
    assert make(project, "pendulum", check=True).changed == ()
    assert contents(project.root) == made
    passed = [json.loads(made[n])["passed"] for n in EMITTED if n.endswith("certificate.json")]
    assert passed == [True, True]


# --- the same with what a kernel has given once --------------------------------------------------


@cache
def recorded() -> tuple[Any, dict[str, str]]:
    """A notebook and the files of an emission; what is in them does not matter here."""
    cells = [nbformat.v4.new_code_cell("1 + 1", id="cell-000")]
    files = {name.removeprefix("generated/"): f"text of {name}\n" for name in EMITTED}
    return nbformat.v4.new_notebook(cells=cells), files


@pytest.fixture
def staged(monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """`make` with a kernel that only hands over what is recorded; changes are for the test."""
    notebook, files = recorded()
    state: dict[str, Any] = {"files": dict(files), "failures": [], "png": {}, "publish": True}

    def execute(script: Path, environment: dict[str, str], folder: Path, progress: Any) -> Any:
        assert folder == script.parent
        assert environment["PYTHONPATH"].split(os.pathsep)[0] == str(folder)
        state["kept"] = environment[KEPT]
        stage = Path(environment[STAGE])
        for name, data in state["png"].items():
            (stage / name).write_bytes(data)
        if state["publish"]:
            text = json.dumps({"files": state["files"], "failures": state["failures"]})
            (stage / "emission.json").write_text(text, encoding="utf-8")
        return notebook

    monkeypatch.setattr(pipeline, "execute", execute)
    return state


@pytest.fixture
def project(tmp_path: Path) -> Project:
    return small_project(tmp_path / "project")


def damage(project: Project, name: str) -> dict[str, Callable[[], None]]:
    path = project.root / name

    def edited() -> None:
        path.write_bytes(path.read_bytes() + b"\n# by hand\n")

    def stale() -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("of yesterday", encoding="utf-8")

    return {"edited": edited, "missing": path.unlink, "stale": stale}


@pytest.mark.parametrize(
    ("name", "how"),
    [
        (EMITTED[-1], "edited"),
        (EMITTED[0], "edited"),
        (EMITTED[3], "missing"),
        (NOTEBOOK, "edited"),
        (NOTEBOOK, "missing"),
        (f"{FOLDER}/Omega_is_omega_order_1.py", "stale"),
        (f"{FOLDER}/Omega_is_omega_order_1.certificate.json", "stale"),
        (f"{FOLDER}/.nonresonant_order_1.py.k3j2", "stale"),
    ],
)
def test_check_tells_and_make_repairs(
    project: Project, staged: dict[str, Any], name: str, how: str
) -> None:
    make(project, "pendulum")
    good = contents(project.root)
    damage(project, name)[how]()
    before = contents(project.root)
    assert before != good
    outcome = make(project, "pendulum", check=True)
    assert outcome.changed == (name,)
    assert contents(project.root) == before
    assert make(project, "pendulum").changed == (name,)
    assert contents(project.root) == good
    assert make(project, "pendulum", check=True).changed == ()


def test_other_models_and_files_beside_are_left_alone(
    project: Project, staged: dict[str, Any]
) -> None:
    others = {
        "generated/mms_functions/rotor/case_order_1.py": b"another derivation's",
        "generated/mms_functions/note.txt": b"beside",
        "docs/figures/rotor.png": b"another derivation's",
    }
    for name, data in others.items():
        (project.root / name).parent.mkdir(parents=True, exist_ok=True)
        (project.root / name).write_bytes(data)
    cache = project.root / FOLDER / "__pycache__"
    cache.mkdir(parents=True)
    make(project, "pendulum")
    now = contents(project.root)
    assert {name: now[name] for name in others} == others
    assert cache.is_dir()


def test_a_case_that_fails_takes_its_files_with_it(
    project: Project, staged: dict[str, Any]
) -> None:
    make(project, "pendulum")
    gone = [n for n in EMITTED if "order_2" in n]
    assert len(gone) == 3
    for name in gone:
        del staged["files"][name.removeprefix("generated/")]
    staged["failures"] = ["order 2: the error falls like ε^1"]
    outcome = make(project, "pendulum")
    assert outcome.failures == ("order 2: the error falls like ε^1",)
    assert list(outcome.changed) == gone
    assert not any("order_2" in name for name in without_build(project.root))


def png(value: float) -> bytes:
    import io

    import numpy as np

    image = pytest.importorskip("matplotlib.image")
    data = io.BytesIO()
    image.imsave(data, np.full((20, 20, 3), value), format="png")
    return data.getvalue()


def test_figures_change_only_beyond_the_tolerance(project: Project, staged: dict[str, Any]) -> None:
    staged["png"]["pendulum.png"] = png(0.5)
    name = "docs/figures/pendulum.png"
    assert name in make(project, "pendulum").changed
    # the alpha channel is the same: the root mean square is 0.87 of the step
    staged["png"]["pendulum.png"] = png(0.51)
    assert make(project, "pendulum").changed == ()
    assert (project.root / name).read_bytes() == png(0.5)
    staged["png"]["pendulum.png"] = png(0.6)
    assert make(project, "pendulum", check=True).changed == (name,)
    assert (project.root / name).read_bytes() == png(0.5)
    assert make(project, "pendulum").changed == (name,)
    assert (project.root / name).read_bytes() == png(0.6)


def test_certificates_are_kept_for_make_and_not_for_check(
    project: Project, staged: dict[str, Any]
) -> None:
    make(project, "pendulum")
    assert staged["kept"] == str(project.root / "build" / "certificates")
    make(project, "pendulum", check=True)
    assert staged["kept"] == ""


@pytest.mark.parametrize("error", [KeyboardInterrupt, OSError])
@pytest.mark.parametrize("after", [0, 1, 4])
def test_an_interrupted_make_goes_on_where_it_was(
    tmp_path: Path, staged: dict[str, Any], after: int, error: type[BaseException]
) -> None:
    whole = small_project(tmp_path / "whole")
    make(whole, "pendulum")
    project = small_project(tmp_path / "project")
    sources = contents(project.root)
    replace, done = Path.replace, []

    def interrupted(self: Path, target: Any) -> Path:
        if len(done) == after:
            raise error
        done.append(target)
        return replace(self, target)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Path, "replace", interrupted)
        with pytest.raises(error):
            make(project, "pendulum")
    now = contents(project.root)
    # what is there is whole, and there is nothing else
    assert len(now) == len(sources) + after
    assert all(data == contents(whole.root)[name] for name, data in now.items())
    outcome = make(project, "pendulum")
    assert len(outcome.changed) == len(EMITTED) + 1 - after
    assert contents(project.root) == contents(whole.root)


# --- errors ---------------------------------------------------------------------------------------


def test_a_derivation_that_publishes_nothing(project: Project, staged: dict[str, Any]) -> None:
    staged["publish"] = False
    before = contents(project.root)
    with pytest.raises(MmsgenError, match=r"pendulum\.py publishes nothing: end it with mmsgen\."):
        make(project, "pendulum")
    assert contents(project.root) == before


def test_a_derivation_of_figures_alone_leaves_emitted_files(
    project: Project, staged: dict[str, Any]
) -> None:
    staged["files"], staged["png"] = {}, {"shown.png": png(0.5)}
    before = contents(project.root)
    outcome = make(project, "pendulum")
    assert set(outcome.changed) == {NOTEBOOK, "docs/figures/shown.png"}
    now = contents(project.root)
    assert all(now[name] == data for name, data in before.items() if name != NOTEBOOK)


def test_a_derivation_that_fails_writes_nothing(project: Project) -> None:
    text = DERIVATION.replace("scaled.expand(2)", "scaled.expand(0)")
    (project.derivations / "pendulum.py").write_text(text, encoding="utf-8")
    before = contents(project.root)
    with pytest.raises(MmsgenError, match=r"(?s)pendulum\.py fails when executed.*must be a whole"):
        make(project, "pendulum")
    assert without_build(project.root) == before


@pytest.mark.parametrize("name", ["rotor", "shared", "../pendulum", ""])
def test_an_unknown_derivation(project: Project, name: str) -> None:
    shutil.copy(project.derivations / "pendulum.py", project.derivations / "another.py")
    with pytest.raises(MmsgenError) as info:
        make(project, name)
    assert str(info.value) == (f"there is no derivation {name!r}; known are another, pendulum")


def test_the_project_is_found_from_below(project: Project) -> None:
    assert find_project(project.root) == project
    assert find_project(project.derivations) == project
    with pytest.raises(MmsgenError, match=r"no project here: .*pyproject\.toml and derivations"):
        find_project(project.root.parent)
