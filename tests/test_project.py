"""The project itself: linters, the direction of the imports, packaging, and what may be committed.

Everything here holds for the pinned versions and a checkout, not for the lowest versions.
"""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
import tempfile
import tomllib
import zipfile
from collections.abc import Iterator
from graphlib import TopologicalSorter
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

pytestmark = pytest.mark.pinned

ROOT = Path(__file__).resolve().parent.parent
ENGINE = ROOT / "src" / "mmsgen"
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]


def run(*command: str, cwd: Path = ROOT) -> subprocess.CompletedProcess[str]:
    """Run a command, its output captured as text."""
    return subprocess.run(command, cwd=cwd, capture_output=True, text=True, check=False)


def passes(*command: str, cwd: Path = ROOT) -> str:
    """Run a command that has to succeed; its output."""
    done = run(*command, cwd=cwd)
    assert done.returncode == 0, f"{' '.join(command)}\n{done.stdout}{done.stderr}"
    return done.stdout


def tracked() -> list[str]:
    """The files under version control."""
    listing = run("git", "ls-files", "-z")
    if listing.returncode != 0:
        pytest.skip("not a git checkout")
    return [name for name in listing.stdout.split("\0") if name and (ROOT / name).is_file()]


# --- linters --------------------------------------------------------------------------------------


def test_ruff() -> None:
    passes(sys.executable, "-m", "ruff", "check", "--quiet", ".")


def test_mypy() -> None:
    passes(sys.executable, "-m", "mypy")


# --- proportions ----------------------------------------------------------------------------------


MAX_FILE_LINES, MAX_FUNCTION_LINES = 400, 60


def hand_written() -> Iterator[Path]:
    """Code written by hand; percent-format notebooks, which are read as documents, left out."""
    for folder in ("src", "tests", "benchmarks"):
        yield from sorted((ROOT / folder).rglob("*.py"))


def code_lines(function: ast.FunctionDef | ast.AsyncFunctionDef) -> int:
    """Lines of a function without its docstring, of which there can hardly be too many."""
    lines = (function.end_lineno or function.lineno) - function.lineno + 1
    first = function.body[0]
    if ast.get_docstring(function) is not None:
        lines -= (first.end_lineno or first.lineno) - first.lineno + 1
    return lines


def test_files_and_functions_fit_the_screen() -> None:
    offenders = []
    for path in hand_written():
        text = path.read_text("utf-8")
        name = path.relative_to(ROOT)
        if len(text.splitlines()) > MAX_FILE_LINES:
            offenders.append(f"{name}: {len(text.splitlines())} lines")
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                if code_lines(node) > MAX_FUNCTION_LINES:
                    offenders.append(f"{name}: {node.name} has {code_lines(node)} lines")
    assert not offenders, "\n".join(offenders)


def test_no_shortcuts_that_the_engine_forbids() -> None:
    # eval would run an equation string as code; simplify has no canonical form and no bound on
    # its time, and nsimplify turns a float into a guess.
    forbidden = {"eval", "exec", "simplify", "nsimplify"}
    offenders = []
    for path in sorted(ENGINE.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.Call):
                function = node.func
                name = function.attr if isinstance(function, ast.Attribute) else None
                name = function.id if isinstance(function, ast.Name) else name
                if name in forbidden:
                    offenders.append(f"{path.relative_to(ROOT)}:{node.lineno}: {name}()")
    assert not offenders, "\n".join(offenders)


# --- the direction of the imports -----------------------------------------------------------------

# What all others stand on, and which stands on nothing but itself.
BASE = ("errors", "parameters", "symbols", "_version")
# The algebra of harmonics: below the stages, which call it.
ALGEBRA = ("series",)
# From the Lagrangian to the boundary: a stage returns the next record, so it may import what comes
# after it, and never what came before it.
STAGES = ("model", "equations", "scaling", "resonance", "expansion", "slowflow", "boundary")
# From a result to the emitted code, and the evidence for it.
OUTPUT = ("ir", "codegen", "certify", "conventions")
# What shows or conducts: nothing above may need it.
LEAVES = ("plotting", "report", "pipeline", "cli", "__main__")


def runtime_nodes(node: ast.AST) -> Iterator[ast.AST]:
    """Walk a tree, leaving out what stands under `if TYPE_CHECKING:`."""
    yield node
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.If) and "TYPE_CHECKING" in ast.unparse(child.test):
            for other in child.orelse:
                yield from runtime_nodes(other)
        else:
            yield from runtime_nodes(child)


def imported(tree: ast.AST, package: tuple[str, ...], modules: set[str]) -> set[str]:
    """Modules of mmsgen that a module of `package` imports at run time, wherever in its text."""
    names: set[tuple[str, ...]] = set()
    for node in runtime_nodes(tree):
        if isinstance(node, ast.Import):
            names |= {tuple(alias.name.split(".")) for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            above = package[: len(package) + 1 - node.level] if node.level else ()
            origin = (*above, *(node.module.split(".") if node.module else ()))
            names |= {(*origin, alias.name) for alias in node.names}
    return {name[1] for name in names if name[0] == "mmsgen" and len(name) > 1} & modules


@pytest.fixture(scope="module")
def imports() -> dict[str, set[str]]:
    """Each module (or subpackage) of mmsgen, and those that it imports at run time."""
    paths = [path.relative_to(ENGINE.parent) for path in sorted(ENGINE.rglob("*.py"))]
    modules = {path.with_suffix("").parts[1] for path in paths} - {"__init__"}
    graph: dict[str, set[str]] = {name: set() for name in modules}
    for path in paths:
        name = path.with_suffix("").parts[1]
        if name in modules:
            tree = ast.parse((ENGINE.parent / path).read_text("utf-8"))
            graph[name] |= imported(tree, path.parts[:-1], modules) - {name}
    return graph


def reach(imports: dict[str, set[str]], start: str) -> set[str]:
    """What a module imports, and what that imports, and so on."""
    found: set[str] = set()
    todo = [start]
    while todo:
        new = imports.get(todo.pop(), set()) - found
        found |= new
        todo += sorted(new)
    return found


def test_imports_have_no_cycle(imports: dict[str, set[str]]) -> None:
    assert len(tuple(TopologicalSorter(imports).static_order())) == len(imports)


def test_base_modules_import_nothing_above_them(imports: dict[str, set[str]]) -> None:
    for name in BASE:
        assert imports.get(name, set()) <= set(BASE), name
    for name in ALGEBRA:
        assert not reach(imports, name) & {*STAGES, *OUTPUT, *LEAVES, "floquet"}, name


def test_no_stage_reaches_back(imports: dict[str, set[str]]) -> None:
    # Not even through a helper module.
    for place, name in enumerate(STAGES):
        assert not reach(imports, name) & set(STAGES[:place]), name


def test_floquet_knows_nothing_of_expansions(imports: dict[str, set[str]]) -> None:
    # The reference has to be independent of what it certifies.
    assert imports.get("floquet", set()) <= {"errors", "parameters", "_version"}


def test_orbits_know_nothing_of_expansions(imports: dict[str, set[str]]) -> None:
    # As `floquet`, whose collocation and error bounds they share.
    allowed = {"errors", "parameters", "numeric", "floquet", "_version"}
    assert imports.get("orbits", set()) <= allowed


def test_nothing_depends_on_a_leaf(imports: dict[str, set[str]]) -> None:
    for name, needed in imports.items():
        if name not in LEAVES:
            assert not needed & set(LEAVES), name


def test_the_reader_of_imports_sees_what_python_would_import() -> None:
    source = """
from __future__ import annotations
from typing import TYPE_CHECKING
import mmsgen.floquet
from mmsgen import series
from .model import other
from ..errors import ModelError
if TYPE_CHECKING:
    from ..expansion import Expansion
def late():
    from .. import scaling
"""
    modules = {"floquet", "series", "errors", "expansion", "scaling", "model"}
    expected = {"floquet", "series", "errors", "scaling"}
    assert imported(ast.parse(source), ("mmsgen", "ir"), modules) == expected
    assert imported(ast.parse("from .model import x"), ("mmsgen",), modules) == {"model"}


# --- importing and packaging ----------------------------------------------------------------------


def test_import_is_silent_and_leaves_the_extras_alone() -> None:
    extras = ("matplotlib", "jupytext", "nbclient", "nbformat", "IPython", "typer", "rich")
    code = (
        "import sys\n"
        f"sys.modules.update(dict.fromkeys({extras!r}))\n"  # None: importing it raises
        "import mmsgen\n"
        "print(mmsgen.__version__)"
    )
    assert re.fullmatch(r"\d+\.\d+\.\d+\n", passes(sys.executable, "-W", "error", "-c", code))


def test_command_line_without_its_extra_says_what_to_install() -> None:
    code = "import sys; sys.modules['typer'] = None; from mmsgen.__main__ import main; main()"
    done = run(sys.executable, "-c", code)
    assert done.returncode == 1
    assert "typer" in done.stderr
    assert "mmsgen[cli]" in done.stderr
    assert "Traceback" not in done.stderr


def test_wheel_holds_both_packages_and_the_type_marker(tmp_path: Path) -> None:
    passes(sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(tmp_path))
    (wheel,) = tmp_path.glob("*.whl")
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
        archive.extractall(tmp_path / "installed")
    assert "mmsgen/py.typed" in names
    for base in ("src", "generated"):
        for path in (ROOT / base).rglob("*.py"):
            assert path.relative_to(ROOT / base).as_posix() in names
    top = {name.split("/")[0] for name in names if ".dist-info" not in name}
    assert top <= {"mmsgen", "mms_functions"}
    code = (
        f"import sys; sys.path.insert(0, {str(tmp_path / 'installed')!r})\n"
        "import mmsgen; print(mmsgen.__file__)"
    )
    assert str(tmp_path) in passes(sys.executable, "-c", code, cwd=tmp_path)


# --- dependencies ---------------------------------------------------------------------------------


def requirements() -> Iterator[Requirement]:
    """Every requirement that pyproject.toml states, those of the extras among them."""
    stated = list(PROJECT["dependencies"])
    for extra in PROJECT["optional-dependencies"].values():
        stated += extra
    for text in stated:
        requirement = Requirement(text)
        if requirement.name != PROJECT["name"]:
            yield requirement


def pins(name: str) -> dict[str, str]:
    """Versions by name from a constraints file, which holds nothing else."""
    table = {}
    for line in (ROOT / name).read_text("utf-8").splitlines():
        if line and not line.startswith("#"):
            match = re.fullmatch(r"([A-Za-z0-9._-]+)==([A-Za-z0-9.]+)", line)
            assert match, f"{name}: {line!r} is not of the form name==version"
            table[canonicalize_name(match[1])] = match[2]
    return table


def test_every_dependency_has_a_lower_bound_a_pin_and_a_reason() -> None:
    pinned = pins("constraints.txt")
    contributing = (ROOT / "CONTRIBUTING.md").read_text("utf-8")
    for requirement in requirements():
        name = requirement.name
        assert [clause.operator for clause in requirement.specifier] == [">="], name
        assert requirement.specifier.contains(pinned[canonicalize_name(name)]), name
        row = re.search(rf"^\| {re.escape(name)} \|(.*)\|$", contributing, re.MULTILINE)
        assert row and len(row[1]) > 20, f"CONTRIBUTING.md gives no reason for {name}"


def test_lowest_constraints_are_the_lower_bounds() -> None:
    extras = PROJECT["optional-dependencies"]
    stated = [*PROJECT["dependencies"], *extras["plot"], *extras["notebook"], *extras["cli"]]
    lowest = pins("constraints-lowest.txt")
    for requirement in map(Requirement, [*stated, *extras["test"]]):
        (clause,) = requirement.specifier
        assert lowest[canonicalize_name(requirement.name)] == clause.version, requirement.name


# --- what the README promises ---------------------------------------------------------------------


def test_make_help_lists_every_target() -> None:
    text = (ROOT / "Makefile").read_text("utf-8")
    phony = re.search(r"^\.PHONY: (.*)$", text, re.MULTILINE)
    assert phony
    listed = re.findall(r"^  make ([a-z-]+) ", passes("make", "--no-print-directory", "help"), re.M)
    assert set(listed) == set(phony[1].split()) - {"FORCE"}


def test_continuous_integration_runs_the_test_command_of_the_readme() -> None:
    readme = (ROOT / "README.md").read_text("utf-8")
    script = ROOT / ".ci" / "run"
    assert re.search(r"^ {4}make +#", readme, re.MULTILINE)
    assert re.search(r"^ {4}make test +#", readme, re.MULTILINE)
    assert script.read_text("utf-8").rstrip().endswith("\nmake test")
    assert os.access(script, os.X_OK)


# --- what may be committed ------------------------------------------------------------------------


def forbidden() -> re.Pattern[str]:
    """Paths of a machine, this one's among them, and where a package index may be."""
    folders = {str(folder) for folder in (Path.home(), Path(tempfile.gettempdir()), *ROOT.parents)}
    roots = {re.escape(folder) for folder in folders if len(folder) > 1}
    paths = "|".join(sorted({*roots, "/(?:home|root|tmp|Users)", r"[A-Z]:\\+Users"}))
    options = "|".join(f"{word}-(?:url|host|links)" for word in ("index", "trusted", "find"))
    return re.compile(rf"(?<![\w.~}})*/-])(?:{paths})[/\\][^\s|)]|--?(?:extra-)?(?:{options})")


def test_no_machine_and_no_package_index_is_named_in_a_tracked_file() -> None:
    pattern = forbidden()
    offenders = []
    for name in tracked():
        try:
            text = (ROOT / name).read_text("utf-8")
        except UnicodeDecodeError:
            continue  # an image
        for number, line in enumerate(text.splitlines(), 1):
            if pattern.search(line):
                offenders.append(f"{name}:{number}: {line.strip()[:100]}")
    assert not offenders, "\n".join(offenders)


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (f"open('{ROOT.parent}/notes')", True),
        ("/" + "home/somebody/x.py", True),
        ("see /" + "tmp/out", True),
        ("pip install --extra-index" + "-url x", True),
        ("src/home/page and ./tmp/x", False),
        ("#!/usr/bin/env bash", False),
    ],
)
def test_the_forbidden_pattern_bites(text: str, found: bool) -> None:
    assert bool(forbidden().search(text)) is found


def test_committed_text_is_plain_and_ends_with_a_newline() -> None:
    for name in tracked():
        data = (ROOT / name).read_bytes()
        if data and b"\0" not in data:
            assert data.endswith(b"\n"), f"{name} has no newline at its end"
            assert b"\r\n" not in data, f"{name} has CRLF line ends"
