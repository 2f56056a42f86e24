"""Run the examples as whole processes, ours and the peers' in turn, and keep what they report.

    python measure.py [--rounds N] [EXAMPLE ...]

Every run leaves one file in build/peers. A peer that takes longer than `LONG` is run once.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
BUILD = ROOT / "build" / "peers"
OURS, THEIRS = ROOT / ".venv" / "bin" / "python", ROOT / ".venv-peers" / "bin" / "python"

LONG = 120.0
"""Seconds from which one run of a peer is enough."""

LIMIT = 1500.0
"""Seconds after which a peer is stopped."""

INSTALLED = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
"""With bytecode, as installed packages have it."""

OSCILATE = (
    "duffing",
    "parametric_duffing",
    "parametric_rayleigh",
    "one_to_two",
    "one_to_three",
    "one_to_one",
    "van_der_pol",
    "superharmonic",
    "subharmonic",
    "centrifugal_pendulum",
    "odd_nonlinearity",
    "duffing_complex",
)
ASYMPTOTICS = (
    "damped",
    "damped_at_two",
    "cubic",
    "limit_cycle",
    "strained_cubic",
    "strained_cubic_at_two",
)
PROGRAMS = {
    "oscilate": (THEIRS, "with_oscilate.py"),
    "asymptotics": (THEIRS, "with_asymptotics.py"),
    "mmsgen": (OURS, "with_mmsgen.py"),
}


def peer_of(example: str) -> str:
    return "oscilate" if example in OSCILATE else "asymptotics"


def run(tool: str, example: str) -> dict[str, Any]:
    """One whole process: wall-clock and processor time, and what it reports."""
    python, script = PROGRAMS[tool]
    before = os.times()
    start = time.perf_counter()
    try:
        done = subprocess.run(
            [str(python), str(HERE / script), example],
            capture_output=True,
            text=True,
            timeout=LIMIT,
            check=True,
            env=INSTALLED,
        )
    except subprocess.TimeoutExpired:
        return {"stopped": LIMIT}
    wall = time.perf_counter() - start
    after = os.times()
    processor = after.children_user + after.children_system
    processor -= before.children_user + before.children_system
    report: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
    return {"wall": wall, "processor": processor, **report}


def keep(tool: str, example: str, index: int) -> dict[str, Any]:
    """Run and write down."""
    report = run(tool, example)
    name = BUILD / f"{example}-{tool}-{index}.json"
    name.write_text(json.dumps(report, indent=1) + "\n", "utf-8")
    shown = [f"{key} {report.get(key, LIMIT):8.2f} s" for key in ("wall", "processor", "slow_flow")]
    print(f"{example:24s} {tool:12s}", *shown, flush=True)
    return report


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("examples", nargs="*")
    chosen = parser.parse_args()
    unknown = set(chosen.examples) - {*OSCILATE, *ASYMPTOTICS}
    if unknown:
        sys.exit(f"no such example: {', '.join(sorted(unknown))}")
    BUILD.mkdir(parents=True, exist_ok=True)
    compile_all = ["-m", "compileall", "-q", str(ROOT / "src" / "mmsgen"), str(HERE)]
    subprocess.run([str(OURS), *compile_all], check=True)
    for example in chosen.examples or (*ASYMPTOTICS, *OSCILATE):
        peer, long = peer_of(example), False
        for index in range(chosen.rounds):
            if not long:
                long = keep(peer, example, index).get("wall", LIMIT) > LONG
            keep("mmsgen", example, index)


if __name__ == "__main__":
    main()
