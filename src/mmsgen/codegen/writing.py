"""Files written whole or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterable, Mapping
from contextlib import suppress
from pathlib import Path

__all__ = ["differing", "remove_files", "write_files"]


def differing(directory: Path, files: Mapping[str, str]) -> tuple[str, ...]:
    """Relative paths whose content is not what it should be, in their order."""
    return tuple(path for path, text in files.items() if _read(directory / path) != text.encode())


def _read(path: Path) -> bytes | None:
    try:
        return path.read_bytes()
    except (FileNotFoundError, NotADirectoryError):
        return None


def write_files(directory: Path, files: Mapping[str, str]) -> tuple[Path, ...]:
    """Write files, each of them by a rename, after all of them have been written beside it.

    Files that have their content already are left alone, so that nothing is made again for them.

    Parameters
    ----------
    directory : pathlib.Path
    files : mapping
        Relative path → text.

    Returns
    -------
    tuple of pathlib.Path
        The files that have changed.
    """
    changed = differing(directory, files)
    staged: list[tuple[str, Path]] = []
    try:
        for name in changed:
            target = directory / name
            target.parent.mkdir(parents=True, exist_ok=True)
            staged.append((_stage(target, files[name]), target))
        for temporary, target in staged:
            os.replace(temporary, target)
    finally:
        for temporary, _ in staged:
            with suppress(FileNotFoundError):
                os.unlink(temporary)
    return tuple(target for _, target in staged)


def _stage(target: Path, text: str) -> str:
    """Write a temporary file beside the target; its path."""
    handle, temporary = tempfile.mkstemp(prefix=f".{target.name}.", dir=target.parent)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(text.encode())
            file.flush()
            os.fsync(file.fileno())
        os.chmod(temporary, 0o644)
    except BaseException:
        os.unlink(temporary)
        raise
    return temporary


def remove_files(paths: Iterable[Path]) -> None:
    """Remove files that are there."""
    for path in paths:
        path.unlink(missing_ok=True)
