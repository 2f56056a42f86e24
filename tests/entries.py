"""What every derivation of the catalogue has to show: its certificates, and its notebook."""

from __future__ import annotations

import ast
import importlib
import json
import re
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

import jupytext
from latex_values import balanced

ROOT = Path(__file__).resolve().parent.parent
EMITTED = ROOT / "generated" / "mms_functions"


def emitted(name: str, case: str) -> ModuleType:
    """An emitted module."""
    return importlib.import_module(f"mms_functions.{name}.{case}")


def certificates(name: str) -> dict[str, dict[str, Any]]:
    """{module: certificate} of all that is emitted for a derivation."""
    modules = {p.stem for p in EMITTED.glob(f"{name}/*_order_*.py")}
    found = {
        p.name.removesuffix(".certificate.json"): json.loads(p.read_text("utf-8"))
        for p in EMITTED.glob(f"{name}/*.certificate.json")
    }
    assert modules == set(found), f"not every module of {name} is certified"
    assert all(data["passed"] for data in found.values())
    return found


HOPF = ("Hopf", "frequency of the Hopf point")
"""What is certified of a Hopf point."""


def demand_fits(
    data: dict[str, Any],
    tolerance: float,
    steady: bool = True,
    even: bool = False,
    points: Sequence[str] = (),
) -> None:
    """Motions, with a steady motion its amplitudes and stability, and bifurcations err as they may.

    Where even powers of ε alone occur, what would be of an odd one is of the next; and since the
    power after that is higher by two, an exponent between them is one of both terms together.
    """
    kinds = ["motions at times of order 1/ε", "equilibrium amplitudes", "stability"]
    wanted = [*kinds[: 3 if steady else 1], *points]
    assert [fit["quantity"] for fit in data["fits"]] == wanted
    for fit in data["fits"]:
        assert fit["theory"] == data["order"] + (fit["quantity"] not in kinds[:2])
        odd = even and fit["theory"] % 2
        gap = float(fit["fitted"]) - fit["theory"] - odd
        assert -tolerance < gap < (2 if odd else tolerance)


def outputs(name: str) -> list[dict[str, Any]]:
    """All outputs of an executed notebook."""
    notebook = json.loads((ROOT / "derivations" / f"{name}.ipynb").read_text("utf-8"))
    return [o for cell in notebook["cells"] for o in cell.get("outputs", ())]


def demand_notebook(name: str) -> None:
    """The notebook is that of the script, ran through in silence, and its formulas are whole."""
    script = ROOT / "derivations" / f"{name}.py"
    cells = json.loads(script.with_suffix(".ipynb").read_text("utf-8"))["cells"]
    sources = [c.source for c in jupytext.read(script, fmt="py:percent").cells]
    assert ["".join(c["source"]) for c in cells] == sources, "run make"
    code = [c for c in cells if c["cell_type"] == "code"]
    assert [c["execution_count"] for c in code] == list(range(1, len(code) + 1))
    kinds = {o["output_type"] for o in outputs(name)}
    assert kinds <= {"display_data", "execute_result", "stream"}
    texts = ["".join(c["source"]) for c in cells if c["cell_type"] == "markdown"]
    for output in outputs(name):
        assert output.get("name", "stdout") == "stdout"
        data = {kind: "".join(text) for kind, text in output.get("data", {}).items()}
        assert "not emitted:" not in data.get("text/markdown", "")
        texts += [data[kind] for kind in ("text/latex", "text/markdown") if kind in data]
    for text in texts:
        plain = re.sub(r"```.*?```|`[^`]*`", "", text, flags=re.DOTALL)
        assert plain.count("$") % 2 == 0, text
        for display, inline in re.findall(r"\$\$(.*?)\$\$|\$(.*?)\$", plain, flags=re.DOTALL):
            assert balanced(display + inline), text


# -- the cases of a derivation ---------------------------------------------------------------------


def names_of(node: ast.AST) -> set[str]:
    """Names that occur, without those that a loop or a comprehension in it counts with."""
    counting = (n.target for n in ast.walk(node) if isinstance(n, ast.For | ast.comprehension))
    own = {n.id for target in counting for n in ast.walk(target) if isinstance(n, ast.Name)}
    return {n.id for n in ast.walk(node) if isinstance(n, ast.Name)} - own


def makes(statement: ast.stmt) -> set[str]:
    """Names that a statement binds or changes."""
    found = set()
    for node in ast.walk(statement):
        if isinstance(node, ast.FunctionDef):
            found.add(node.name)
        elif isinstance(node, ast.Import | ast.ImportFrom):
            found |= {(alias.asname or alias.name).split(".")[0] for alias in node.names}
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            found.add(node.id)
        elif isinstance(node, ast.Subscript) and isinstance(node.ctx, ast.Store):
            found |= names_of(node.value)
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            if node.func.attr in ("append", "extend", "update") and not isinstance(
                node.func.value, ast.Call
            ):
                found |= names_of(node.func.value)
    return found


class Silent(ast.NodeTransformer):
    """Takes out what only displays."""

    def visit_Expr(self, node: ast.Expr) -> ast.stmt:
        return node if makes(node) else ast.copy_location(ast.Pass(), node)


@cache
def cases_of(name: str) -> tuple[Any, ...]:
    """The cases that a derivation emits, made by those of its statements that they follow from."""
    path = ROOT / "derivations" / f"{name}.py"
    tree = ast.parse(path.read_text("utf-8"))
    calls = (n for n in ast.walk(tree) if isinstance(n, ast.Call))
    (emission,) = (n for n in calls if ast.unparse(n.func) == "mg.Emission")
    (cases,) = (k.value for k in emission.keywords if k.arg == "cases")
    needed = names_of(cases)
    kept: list[ast.stmt] = []
    for statement in reversed([s for s in tree.body if s.lineno < emission.lineno]):
        if makes(statement) & needed:
            kept.append(Silent().visit(statement))
            needed |= names_of(statement)
    program = ast.Module([*reversed(kept), ast.Assign([ast.Name("cases", ast.Store())], cases)], [])
    space: dict[str, Any] = {"__name__": name}
    exec(compile(ast.fix_missing_locations(program), str(path), "exec"), space)
    return tuple(space["cases"])
