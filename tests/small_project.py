"""A project as small as can be: one derivation of one oscillator, for tests of `make`."""

from __future__ import annotations

from pathlib import Path

from mmsgen.codegen.kernels import SHARED as RUNTIME
from mmsgen.pipeline import Project

DERIVATION = """\
# %% [markdown]
# # A pendulum whose pivot moves
#
# Text.

# %%
import sympy as sp
from shared import omega
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg

t = dynamicsymbols._t
x = dynamicsymbols("x")
f, Omega = sp.symbols("f Omega", positive=True)
left = x.diff(t, 2) + (omega**2 + f * sp.cos(Omega * t)) * x
parameters = [mg.Parameter(s, "1") for s in (omega, f, Omega)]
eom = mg.Model.from_equations([left], [x], parameters).equations_of_motion()
eom.equations[0]

# %%
scaled = eom.scale({f: 1})
cases = [scaled.expand(1), scaled.expand(2)]
print(cases[0].slow_flow.matrix)


def samples(case):
    return {"omega": 2.3, "f": 4.9, "Omega": 3.1}


# %%
emission = mg.Emission("pendulum", cases, samples, derivation="derivations/pendulum.py")
print(*emission.certificates.values(), sep="\\n")

# %%
print(mg.publish(emission))
"""

SHARED = """\
import sympy as sp

omega = sp.Symbol("omega", positive=True)
"""

WRONG = """\
# %%
import functools

import mmsgen.emission as emitting

right = emitting.load_files


def wrong(files, names):
    modules = right(files, names)
    module = modules["nonresonant_order_2"]
    matrix = module.slow_flow_matrix
    module.slow_flow_matrix = functools.wraps(matrix)(lambda **values: 1.01 * matrix(**values))
    return modules


emitting.load_files = wrong

"""
"""A cell that makes one coefficient of the second case wrong by one per cent."""


def small_project(folder: Path, script: str = DERIVATION) -> Project:
    """Write the project into a folder."""
    (folder / "derivations").mkdir(parents=True)
    (folder / "pyproject.toml").write_text("[project]\n", encoding="utf-8")
    (folder / "derivations" / "shared.py").write_text(SHARED, encoding="utf-8")
    (folder / "derivations" / "pendulum.py").write_text(script, encoding="utf-8")
    return Project(folder)


def contents(folder: Path) -> dict[str, bytes]:
    """Every file of a folder, but Python's own."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file() and "__pycache__" not in path.parts
    }


FOLDER = "generated/mms_functions/pendulum"
CASES = [
    f"{FOLDER}/nonresonant_order_{k}{ending}"
    for k in (1, 2)
    for ending in (".certificate.json", ".py", ".reference.json")
]
EMITTED = sorted(
    [
        "generated/mms_functions/__init__.py",
        *(f"generated/mms_functions/{name}.py" for name in RUNTIME),
        f"{FOLDER}/__init__.py",
        *CASES,
    ]
)
