"""An example through the public interface of asymptotics, as its documentation has it.

    python with_asymptotics.py EXAMPLE

prints one line of JSON as `with_oscilate.py` does: the rates of A and B in A cos ω₀t + B sin ω₀t,
or the frequency that the Lindstedt-Poincaré method gives. Runs in an environment of its own.
"""

from __future__ import annotations

import contextlib
import io
import json
import sys
import time

import asymptotics
from autonomous import EXAMPLES, Autonomous


def solve(example: Autonomous) -> dict[str, str]:
    """The tool's own result, as text."""
    start = ["u(0) = 1", "u'(0) = 0"]
    equation = asymptotics.ODE(example.text, small_param="eps", conditions=start)
    if example.strained:
        return {"frequency": str(equation.expand_lindstedt(order=example.order).omega_expansion)}
    expansion = equation.expand_multiple_scales(order=example.order)
    cosine, sine = expansion.solvability_odes[-1]
    return {"A": str(cosine.rhs), "B": str(sine.rhs)}


def main() -> None:
    example = EXAMPLES[sys.argv[1]]
    begun = time.process_time()
    with contextlib.redirect_stdout(io.StringIO()):
        rates = solve(example)
    done = time.process_time()
    print(json.dumps({"slow_flow": done - begun, "analysis": 0.0, "rates": rates}))


if __name__ == "__main__":
    main()
