"""The emitted `modes`: natural frequencies and mode shapes from the parameters of the equations."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import mpmath

from ..ir import compute_ir, fresh
from ..modes import Component
from ..runtime._eigenmodes import Layout
from .exact import exact
from .kernels import EmittedFunction, Kernel, Reference
from .numpy_target import LINE_LENGTH, wrapped
from .setting import Setting, values_of

__all__ = ["mode_points", "modes_function"]

#: rounding errors of a double eigenproblem, in units of ‖H‖ over the gap between eigenvalues
UNITS = mpmath.mpf(2) ** -53 * 256


def modes_function(setting: Setting) -> EmittedFunction | None:
    """The function `modes` of a case, None where no modes are named."""
    modes = setting.case.weak.scaled.modes
    if not modes.components:
        return None
    present = set().union(*(e.free_symbols for e in modes.entries))
    arguments = tuple(p for p in setting.case.parameters if p.symbol in present)
    names = [p.name for p in arguments]
    out = fresh("out", names)
    outputs = {f"{out}[..., {i}]": e for i, e in enumerate(modes.entries) if e != 0}
    ir = compute_ir(f"{setting.name}.modes", [p.symbol for p in arguments], outputs)
    entries = f"{{evaluate_array}}({{_leading}}, {{arguments}}, ({len(modes.entries)},)).real"
    used = {p.name for p in setting.parameters}
    layouts = [_of_use(layout, used) for layout in modes.layouts]
    text = "\n".join(map(_layout_text, layouts))
    body = f"{{modal_values}}(\n        {entries},\n        (\n{text}\n        ),\n    )"

    def reference(point: Mapping[str, Any]) -> Reference:
        own = values_of(point, arguments)
        values: list[Any] = []
        errors: list[Any] = []
        for component, layout in zip(modes.components, layouts, strict=True):
            numbers, bounds = _exact_values(component, layout, own)
            values += numbers
            errors += bounds
        return Reference(own, (len(values),), tuple(values), tuple(errors))

    return EmittedFunction(
        name="modes",
        arguments=arguments,
        body=body,
        returns="dict[str, Any]",
        summary="Natural frequencies and mode shapes, as keywords for the other functions.",
        description=(
            "Of M0 q'' + G0 q' + K0 q = 0, the leading order. The shape φ = Φ + iΘ of a mode is "
            "scaled by φᴴ(2ω M0 - iG0)φ = 2ω, which is Φᵀ M0 Φ = 1 without gyroscopic terms; its "
            "largest component is positive, or i times positive."
        ),
        result="Name -> float64, in the shape to which the arguments broadcast; NaN where M0 or K0 "
        "is not positive definite.",
        reference=reference,
        kernels=(Kernel("_leading", ir, leading=(out,)),),
        uses=("evaluate_array", "modal_values"),
    )


def _of_use(layout: Layout, used: set[str]) -> Layout:
    """A layout with the names that the slow flow takes, and no others."""
    n, quadrature, factors, frequencies, components = layout
    return (
        n,
        quadrature,
        factors,
        tuple((name if name in used else "", multiple) for name, multiple in frequencies),
        tuple(entry for entry in components if entry[0] in used),
    )


def _layout_text(layout: Layout) -> str:
    """A layout as Python text."""
    rows = []
    for part in layout:
        line = f"                {part!r},"
        if isinstance(part, tuple) and len(line) > LINE_LENGTH:
            inner = wrapped([repr(entry) for entry in part], 20)
            line = "\n".join(("                (", *inner, "                ),"))
        rows.append(line)
    return "\n".join(("            (", *rows, "            ),")).replace("'", '"')


def mode_points(function: EmittedFunction, count: int) -> list[dict[str, Any]]:
    """Points at which M0 and K0 are positive definite, where there are such points."""
    points = []
    for i in range(count):
        chosen: dict[str, Any] | None = None
        for attempt in range(24):
            point = {
                p.name: mpmath.mpf(3 + (7 * k + 5 * i + 11 * attempt * (k + 1)) % 29) / 16
                for k, p in enumerate(function.arguments)
            }
            chosen = chosen or point
            assert function.reference is not None
            found = function.reference(point)
            if found is not None and all(mpmath.isfinite(v) for v in found.values):
                chosen = point
                break
        assert chosen is not None
        points.append(chosen)
    return points


def _exact_values(
    component: Component, layout: Layout, point: Mapping[str, Any]
) -> tuple[list[Any], list[Any]]:
    """Frequencies and shapes of one set of coordinates to the working precision, with errors."""
    _, quadrature, _, frequencies, components = layout
    n = len(component.members)
    matrices = [
        mpmath.matrix([[exact(m[j, i], point) for i in range(n)] for j in range(n)])
        for m in component.matrices
    ]
    wanted = list(dict.fromkeys(name for name, _ in frequencies if name))
    try:
        omega, shapes, size = _eigenproblem(*matrices)
    except ValueError:  # not positive definite
        number = len(wanted) + len(components)
        return [mpmath.nan] * number, [mpmath.mpf(0)] * number
    squares: list[Any] = []
    for coefficients, multiplicity in component.factors:
        roots = mpmath.polyroots(
            [exact(c, point) for c in reversed(coefficients)], maxsteps=200, extraprec=200
        )
        squares += [x for x in sorted(map(mpmath.re, roots)) for _ in range(multiplicity)]
    order = sorted(range(n), key=lambda r: squares[r])
    place = {mode: index for index, mode in enumerate(order)}
    gap = min((abs(a - b) for k, a in enumerate(omega) for b in omega[:k]), default=omega[0])
    error = UNITS * n * size * max(omega)
    values, errors = [], []
    for name in wanted:
        mode, multiple = next((r, m) for r, (x, m) in enumerate(frequencies) if x == name)
        values.append(omega[place[mode]] / mpmath.mpf(multiple))
        errors.append(error)
    for _, row, mode, imaginary in components:
        column = _turned([shapes[j, place[mode]] for j in range(n)], quadrature)
        values.append(mpmath.im(column[row]) if imaginary else mpmath.re(column[row]))
        # shapes of one frequency are any basis of their space
        free = gap < mpmath.mpf(10) ** -20
        errors.append(mpmath.inf if free else error * (1 + 1 / gap) * max(map(abs, column)))
    return values, errors


def _eigenproblem(inertia: Any, gyroscopic: Any, stiffness: Any) -> tuple[list[Any], Any, Any]:
    """Frequencies, ascending, shapes, and the condition of what they are computed from."""
    n = inertia.rows
    root_m, root_k = mpmath.cholesky(inertia), mpmath.cholesky(stiffness)
    inverse = root_m**-1
    h = mpmath.zeros(2 * n, 2 * n)
    coupling, turning = inverse * root_k, inverse * gyroscopic * inverse.T
    for j in range(n):
        for i in range(n):
            h[n + j, i] = h[i, n + j] = coupling[j, i]
            h[n + j, n + i] = mpmath.mpc(0, 1) * turning[j, i]
    values, vectors = mpmath.eighe(h)
    pairs = sorted(range(2 * n), key=lambda r: values[r])[n:]
    shapes = mpmath.zeros(n, n)
    for column, r in enumerate(pairs):
        part = inverse.T * mpmath.matrix([vectors[n + j, r] for j in range(n)])
        for j in range(n):
            shapes[j, column] = mpmath.sqrt(2) * part[j]
    condition = mpmath.mnorm(inverse, "f") * mpmath.mnorm(root_m, "f")
    return [values[r] for r in pairs], shapes, condition


def _turned(column: list[Any], quadrature: Any) -> list[Any]:
    """A shape with its largest component positive, or i times positive."""
    sizes = [abs(x) for x in column]
    lead = next(j for j, x in enumerate(sizes) if x > mpmath.mpf("0.999") * max(sizes))
    unit = mpmath.mpc(0, 1) if quadrature and quadrature[lead] else mpmath.mpf(1)
    turn = unit * abs(column[lead]) / column[lead]
    return [x * turn for x in column]
