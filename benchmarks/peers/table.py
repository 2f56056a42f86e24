"""Write what was measured and compared into docs/peers.md, between its markers.

python table.py
"""

from __future__ import annotations

import json
import platform
from datetime import date
from statistics import median
from typing import Any

import sympy as sp
from compare import exact_gap, gaps, reported
from measure import ASYMPTOTICS, BUILD, LIMIT, OSCILATE, ROOT, peer_of

PAGE = ROOT / "docs" / "peers.md"
KEYS = ("wall", "processor", "slow_flow")
BEGIN, END = "<!-- measured: begin -->", "<!-- measured: end -->"

HEAD = """\
| example | order | process: peer, s | mmsgen, s | ratio | slow flow: peer, s | mmsgen, s | ratio \
| result |
|---|---|---|---|---|---|---|---|---|"""


def runs(example: str, tool: str) -> list[dict[str, Any]]:
    """All runs of a tool that came to their end."""
    found = sorted(BUILD.glob(f"{example}-{tool}-*.json"))
    reports = [json.loads(path.read_text("utf-8")) for path in found]
    return [r for r in reports if "wall" in r]


def middle(reports: list[dict[str, Any]], key: str) -> float:
    return median(r[key] for r in reports)


def short(seconds: float) -> str:
    """With two digits, three above ten."""
    if seconds >= 100:
        return f"{seconds:.0f}"
    return f"{seconds:.3g}" if seconds >= 10 else f"{seconds:.2g}"


def verdict(example: str, report: dict[str, Any]) -> tuple[int, str]:
    """Order of the example, and whether the results agree."""
    order, found = gaps(example, report)
    if min(found) == sp.oo:
        return order, "identical"
    if min(found) > order:
        return order, f"the same through order {order}"
    return order, "differs: see below"


def row(example: str) -> tuple[str, dict[str, float]]:
    """A line of the table; the ratios of the medians."""
    tool = peer_of(example)
    peer, ours = runs(example, tool), runs(example, "mmsgen")
    name = example.replace("_", " ")
    if not peer:
        return f"| {name} | | stopped after {LIMIT:.0f} | | | | | | |", {}
    order, result = verdict(example, reported(example, tool))
    there, here = ({key: middle(r, key) for key in KEYS} for r in (peer, ours))
    ratios = {key: there[key] / here[key] for key in KEYS}
    cells = [f"{short(v['wall'])} ({short(v['processor'])})" for v in (there, here)]
    cells += [f"{short(ratios['wall'])} ({short(ratios['processor'])})"]
    cells += [short(v["slow_flow"]) for v in (there, here, ratios)]
    once = " (once)" if len(peer) == 1 else ""
    return f"| {name}{once} | {order} | {' | '.join(cells)} | {result} |", ratios


def table(tool: str, examples: tuple[str, ...]) -> str:
    measured = [e for e in examples if list(BUILD.glob(f"{e}-{tool}-*.json"))]
    rows = [row(e) for e in measured]
    ratios = [r for _, r in rows if r]
    wall, processor, flow = (short(median(r[key] for r in ratios)) for key in KEYS)
    slowest = max(middle(runs(e, "mmsgen"), "slow_flow") for e in measured)
    closing = (
        f"Medians of the ratios: {wall} as whole processes ({processor} in processor time), {flow} "
        f"from equations to slow flow. The slowest slow flow of mmsgen takes {short(slowest)} s."
    )
    return "\n".join([f"### {tool}", "", HEAD, *(text for text, _ in rows), "", closing])


def machine() -> str:
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        models = [line.split(":", 1)[1].strip() for line in file if line.startswith("model name")]
    return (
        f"Measured on {date.today().isoformat()} with {len(models)} cores ({models[0]}), Python "
        f"{platform.python_version()}, SymPy {sp.__version__}."
    )


def main() -> None:
    text = PAGE.read_text("utf-8")
    before, _, rest = text.partition(BEGIN)
    _, _, after = rest.partition(END)
    parts = [machine(), table("oscilate", OSCILATE), table("asymptotics", ASYMPTOTICS)]
    parts.append(exact_gap())
    measured = "\n\n".join(parts)
    PAGE.write_text(f"{before}{BEGIN}\n\n{measured}\n\n{END}{after}", "utf-8")


if __name__ == "__main__":
    main()
