"""Files written whole or not at all."""

from __future__ import annotations

import os
import stat
from pathlib import Path
from typing import Any

import pytest

from mmsgen.files import write_atomically


def test_text_and_bytes(tmp_path: Path) -> None:
    path = tmp_path / "new" / "folders" / "a.txt"
    assert write_atomically(path, "Γ\nε\n") is True
    assert path.read_bytes() == "Γ\nε\n".encode()
    assert write_atomically(path, b"\x00\r\n") is True
    assert path.read_bytes() == b"\x00\r\n"
    assert [p.name for p in path.parent.iterdir()] == ["a.txt"]


def test_what_has_not_changed_keeps_its_time_stamp(tmp_path: Path) -> None:
    path = tmp_path / "a.txt"
    write_atomically(path, "a")
    os.utime(path, (1, 1))
    assert write_atomically(path, "a") is False
    assert write_atomically(path, b"a") is False
    assert path.stat().st_mtime == 1
    assert write_atomically(path, "b") is True
    assert path.stat().st_mtime > 1


def test_permissions_are_those_of_an_ordinary_file(tmp_path: Path) -> None:
    ordinary = tmp_path / "ordinary"
    ordinary.write_text("a")
    write_atomically(tmp_path / "ours", "a")
    assert stat.S_IMODE((tmp_path / "ours").stat().st_mode) == stat.S_IMODE(ordinary.stat().st_mode)


@pytest.mark.parametrize("error", [KeyboardInterrupt, OSError])
def test_an_interrupted_write_leaves_the_old_file_and_nothing_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, error: type[BaseException]
) -> None:
    path = tmp_path / "a.txt"
    write_atomically(path, "old")

    def interrupted(self: Path, target: Any) -> Path:
        raise error

    with monkeypatch.context() as patch:
        patch.setattr(Path, "replace", interrupted)
        with pytest.raises(error):
            write_atomically(path, "new")
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]
    assert write_atomically(path, "new") is True
    assert path.read_text() == "new"


def test_a_failing_temporary_write_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*args: Any, **kwargs: Any) -> None:
        raise OSError("no space left")

    monkeypatch.setattr(Path, "chmod", full)
    with pytest.raises(OSError, match="no space left"):
        write_atomically(tmp_path / "a.txt", "new")
    assert list(tmp_path.iterdir()) == []
