"""`python -m mmsgen` and the command `mmsgen`: the command line, or how to install what it needs.

Kept apart from `mmsgen.cli`, which cannot be imported without the extra ``cli``.
"""

from __future__ import annotations

import sys
from importlib import import_module
from importlib.util import find_spec

__all__ = ["main"]


def main() -> None:
    """Run the command line.

    Raises
    ------
    SystemExit
        If a package of the extra ``cli`` is not installed, with the remedy; otherwise with the
        exit code of the command.
    """
    missing = [name for name in ("typer", "rich") if find_spec(name) is None]
    if missing:
        sys.exit(
            f"mmsgen: the command line needs {' and '.join(missing)}: "
            "install them with pip install 'mmsgen[cli]'"
        )
    try:
        import_module("mmsgen.cli").app()
    except KeyboardInterrupt:
        sys.exit(130)


if __name__ == "__main__":
    main()
