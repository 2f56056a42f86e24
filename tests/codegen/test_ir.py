"""IR: what is named and reordered is exactly what was passed; what is undeclared is refused."""

from __future__ import annotations

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from mmsgen.errors import EmissionError
from mmsgen.ir import IR, compute_ir, fresh

a, b, c = sp.symbols("a b c", positive=True)
u, v = sp.symbols("u v", real=True)


def restored(ir: IR) -> list[sp.Expr]:
    """The outputs with all intermediates put back."""
    table: dict[sp.Symbol, sp.Expr] = {}
    for symbol, expression in ir.intermediates:
        table[symbol] = expression.xreplace(table)
    return [expression.xreplace(table) for _, expression in ir.outputs]


EXPRESSIONS = [
    a**7 / (b - c) ** 3 + a**7 * c,
    sp.sqrt(a) * sp.sqrt(b) ** 3 / sp.sqrt(c) + sp.sqrt(a * b),
    sp.sqrt(u**2 + v**2) * (u + v) ** 4,
    sp.I * u * (u + v) ** 2 + 3 * sp.Rational(7, 3) * v,
    2 * sp.sqrt(3) * sp.sqrt(a) / 5 - sp.cos(2 * sp.pi / 7) * b,
    1 / (a * sp.sqrt(b)) - 1 / a**2,
    sp.Integer(0),
    a,
]


def test_putting_everything_back_gives_the_same_expressions() -> None:
    ir = compute_ir("f", [a, b, c, u, v], {f"y{k}": e for k, e in enumerate(EXPRESSIONS)})
    for before, after in zip(EXPRESSIONS, restored(ir), strict=True):
        # Exactly, not numerically: both sides expanded over their common denominators.
        assert sp.expand(sp.together(sp.powdenest(before - after, force=True))) == 0


polynomials = st.lists(
    st.tuples(st.integers(-9, 9), *(st.integers(0, 6) for _ in range(3))), max_size=6
)


@given(polynomials, polynomials)
def test_polynomials_are_restored_exactly(
    left: list[tuple[int, ...]], right: list[tuple[int, ...]]
) -> None:
    both = [sp.Add(*(n * a**i * b**j * u**k for n, i, j, k in terms)) for terms in (left, right)]
    ir = compute_ir("f", [a, b, u], {"y": both[0], "z": both[1] / (a + b)})
    y, z = restored(ir)
    assert sp.expand(y - both[0]) == 0
    assert sp.expand(sp.cancel(z * (a + b)) - both[1]) == 0


def test_powers_are_products_of_shared_squares() -> None:
    ir = compute_ir("f", [a], {"y": a**8, "z": a**6})
    assert ir.operations == 4  # a², a⁴, a⁸ and a²·a⁴
    exponents = {p.exp for _, e in (*ir.intermediates, *ir.outputs) for p in e.atoms(sp.Pow)}
    assert exponents <= {2}


def test_roots_of_positive_factors_become_one() -> None:
    ir = compute_ir("f", [a, b, c], {"y": sp.sqrt(a) * sp.sqrt(b) / sp.sqrt(c)})
    roots = [
        p for _, e in (*ir.intermediates, *ir.outputs) for p in e.atoms(sp.Pow) if p.exp.q == 2
    ]
    assert len(roots) == 1
    # Not of factors that may be negative: √u√v is not √(uv).
    ir = compute_ir("f", [u, v], {"y": sp.sqrt(u) * sp.sqrt(v)})
    assert sorted(map(str, restored(ir)[0].args)) == ["sqrt(u)", "sqrt(v)"]


def test_each_intermediate_needs_only_what_is_before_it() -> None:
    ir = compute_ir("f", [a, b, c, u, v], {f"y{k}": e for k, e in enumerate(EXPRESSIONS)})
    known = set(ir.arguments)
    for symbol, expression in ir.intermediates:
        assert expression.free_symbols <= known
        known.add(symbol)
    used = set().union(*(e.free_symbols for _, e in (*ir.intermediates, *ir.outputs)))
    assert {s for s, _ in ir.intermediates} <= used, "an intermediate that nothing needs"


def test_names_of_arguments_are_not_taken() -> None:
    x0, x1, root0, power0 = sp.symbols("x0 x1 root0 power0", positive=True)
    expression = (x0 + x1) ** 5 * sp.sqrt(root0) * power0**3 + (x0 + x1) ** 2
    ir = compute_ir("f", [x0, x1, root0, power0], {"y": expression})
    names = [s.name for s, _ in ir.intermediates]
    assert len(set(names)) == len(names)
    assert not set(names) & {"x0", "x1", "root0", "power0"}
    assert sp.expand(restored(ir)[0] - expression) == 0


def test_an_undeclared_symbol_is_refused_with_inputs_and_remedy() -> None:
    with pytest.raises(EmissionError) as caught:
        compute_ir("growth", [a, b], {"rate": a * c + u})
    message = str(caught.value)
    for part in ("growth", "rate", "c, u", "a, b", "declare"):
        assert part in message


def test_a_float_is_refused() -> None:
    with pytest.raises(EmissionError, match=r"0\.5"):
        compute_ir("growth", [a], {"rate": sp.Float("0.5") * a})


def test_the_digest_tells_formulas_and_domains_apart() -> None:
    one = compute_ir("f", [a], {"y": a + 1})
    assert one.digest == compute_ir("f", [a], {"y": 1 + a}).digest
    other = sp.Symbol("a", real=True)
    digests = {
        one.digest,
        compute_ir("f", [a], {"y": a + 2}).digest,
        compute_ir("f", [other], {"y": other + 1}).digest,
        compute_ir("g", [a], {"y": a + 1}).digest,
    }
    assert len(digests) == 4


def test_fresh_names() -> None:
    assert fresh("x", ["y"]) == "x"
    assert fresh("x", ["x", "x_"]) == "x__"


def test_sines_and_cosines_of_numbers_stay_whole() -> None:
    x, y = sp.symbols("x y", positive=True)
    angle = 2 * sp.pi / 7
    outputs = {
        "a": x * sp.cos(angle) + y * sp.cos(2 * angle),
        "b": x * sp.sin(angle) * sp.exp(sp.I * angle),
    }
    ir = compute_ir("rooted", (x, y), outputs)
    constants = [e for _, e in ir.intermediates if e.atoms(sp.cos, sp.sin)]
    assert constants
    assert all(e.func in (sp.cos, sp.sin) and e.is_number for e in constants)
    values = {x: sp.Rational(3, 2), y: sp.Rational(5, 7)}
    table: dict[sp.Symbol, sp.Expr] = {}
    for symbol, e in ir.intermediates:
        table[symbol] = e.subs({**values, **table})
    for name, e in ir.outputs:
        expected = outputs[name].subs(values)
        # 30 digits of the same number: what is left is the rounding of the evaluation.
        assert abs(sp.N(e.subs({**values, **table}) - expected, 30)) < sp.Float("1e-25")
