"""Certificates kept between runs, so that an interrupted `make` loses none that it has finished.

A certificate is kept under a digest of everything that it follows from: the engine's own sources,
the emitted text, the values. Anything else that changes leaves it valid.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Mapping
from dataclasses import asdict
from functools import cache
from pathlib import Path

from .certificate import Certificate, Fit, Zone
from .files import write_atomically

__all__ = ["certificate_key", "kept"]


@cache
def _engine() -> str:
    """A digest of the engine's sources."""
    folder = Path(__file__).parent
    digest = hashlib.sha256()
    for path in sorted(folder.rglob("*.py")):
        digest.update(path.relative_to(folder).as_posix().encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()


def certificate_key(
    texts: Mapping[str, str], values: Mapping[str, float], numbers: Mapping[str, float]
) -> str:
    """The digest of what a certificate follows from.

    Parameters
    ----------
    texts : mapping
        The emitted files that it runs: path → text.
    values, numbers : mapping
        Name → value, as `certify` takes them.
    """
    parts = [dict(sorted(m.items())) for m in (texts, values, numbers)]
    text = json.dumps([_engine(), *parts], ensure_ascii=False)
    return hashlib.sha256(text.encode()).hexdigest()


def kept(folder: Path | None, key: str, make: Callable[[], Certificate]) -> Certificate:
    """A certificate from the folder, or made and then kept there.

    Parameters
    ----------
    folder : pathlib.Path or None
        None keeps nothing.
    key : str
        From `certificate_key`.
    make : callable
        Makes the certificate.
    """
    if folder is None:
        return make()
    path = folder / f"{key}.json"
    if path.is_file():
        return _read(json.loads(path.read_text(encoding="utf-8")))
    certificate = make()
    text = json.dumps(asdict(certificate), ensure_ascii=False, default=_pair)
    write_atomically(path, text)
    return certificate


def _pair(number: complex) -> tuple[float, float]:
    """A complex number, of which JSON knows nothing."""
    return number.real, number.imag


def _read(data: dict) -> Certificate:  # type: ignore[type-arg]
    """The inverse of `dataclasses.asdict`: JSON knows lists alone."""
    fits = tuple(
        Fit(
            f["quantity"],
            f["theory"],
            tuple(f["epsilons"]),
            tuple(f["errors"]),
            tuple(f["floors"]),
            f["exponent"],
            f["limit"],
            tuple((str(name), float(value)) for name, value in f["place"]),
            tuple(complex(*b) for b in f["near"]),
        )
        for f in data["fits"]
    )
    zones = tuple(
        Zone(z["symbol"], z["unit"], tuple(z["emitted"]), tuple(z["exact"]), z["error"])
        for z in data["zones"]
    )
    values = tuple((str(name), float(value)) for name, value in data["values"])
    return Certificate(data["relation"], data["order"], values, fits, zones)
