# SPDX-License-Identifier: LGPL-2.1-or-later
"""Putting a set of files into a folder so that who looks sees the former set or the new one.

The files are made in a hidden folder inside, `PART`. Renamed to `WHOLE` it is a promise: whatever happens
then, the set is put into its place, by the next run if need be. `BACK` is the opposite promise, after
a failure.

Files are renamed one by one. Meanwhile a screen stands in the place of the folder: a folder beside it with
links to the new files and to all others. Both are exchanged in one step, before and afterwards, so that the
folder itself stays what it is, for programs that work in it too. Folders that have folders inside get no
screen, nor do disks that cannot link or exchange: there the promise alone holds.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import shutil
from collections.abc import Iterable, Mapping
from pathlib import Path

from BalloonWorkbench.core.files.system import exchange, keep_on_disk

PART, WHOLE, BACK = ".film-balloon-part", ".film-balloon-whole", ".film-balloon-back"
_MARK = ".film-balloon-screen"  # a file in each screen: the names of the set
_NEW, _FORMER, _ABSENT = "new", "former", "absent"  # in the hidden folder; absent: names that were not there
_MOST_ENTRIES = 500  # of a folder that gets a screen


def beside(place: Path) -> Path:
    """Where the screen of a folder is made."""
    return place.parent / f".film-balloon-{hashlib.sha256(os.fsencode(place.name)).hexdigest()[:12]}"


def make_folder(place: Path, contents: Mapping[str, bytes]) -> None:
    """Make a folder with these files in one step. Raises OSError, and then there is no folder."""
    screen = beside(place)
    try:
        _mark(screen, contents)
        _stage(screen / PART, place, contents)
        os.rename(screen / PART / _NEW, place)
        keep_on_disk(place.parent)
    finally:
        _remove_screen(screen, place)


def put_files(place: Path, contents: Mapping[str, bytes]) -> None:
    """Put these files into a folder, all or none. Raises OSError, and then none."""
    try:
        _stage(place / PART, place, contents)
        if len(contents) == 1:
            (name,) = contents
            _rename(place / PART / _NEW / name, _final(place / name))
        else:
            _replace_set(place, contents)
        keep_on_disk(place)
    finally:
        _remove(place / PART)


def recover(place: Path) -> None:
    """Finish or undo what a run that was killed left of this folder and beside it. Raises OSError."""
    screen = beside(place)
    if os.path.lexists(place / _MARK):  # the screen is still shown
        if screen.is_dir():
            _settle(screen)
            if not exchange(place, screen):
                raise OSError(0, f"the folder is still in {screen.name} beside it: move it back")
        else:
            os.unlink(place / _MARK)
    if screen.is_dir():
        if os.path.lexists(screen / _MARK) or not os.listdir(screen):
            _remove_screen(screen, place)
        elif not os.path.lexists(place):
            os.rename(screen, place)
    if place.is_dir():
        _settle(place)


def _stage(part: Path, place: Path, contents: Mapping[str, bytes]) -> None:
    """Write the files into a hidden folder, as they will be."""
    for folder in (part, part / _NEW, part / _FORMER, part / _ABSENT):
        os.mkdir(folder)
    for name, content in contents.items():
        target = _final(place / name)
        if target.is_dir():
            raise IsADirectoryError(21, f"{name} is a folder")
        with open(part / _NEW / name, "wb") as stream:
            stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
        if target.exists():
            _as_before(part / _NEW / name, target.stat())


def _as_before(path: Path, former: os.stat_result) -> None:
    """Give a file or folder the mode and, where that is allowed, the owner of a former one."""
    if hasattr(os, "chown") and (former.st_uid, former.st_gid) != (os.geteuid(), os.getegid()):
        with contextlib.suppress(OSError):
            os.chown(path, former.st_uid, former.st_gid)
    os.chmod(path, former.st_mode & 0o7777)


def _final(path: Path) -> Path:
    """The file itself where a link leads to it; a link to nowhere is replaced."""
    if path.is_symlink():
        real = Path(os.path.realpath(path))
        if real.parent.is_dir() and not real.is_symlink():
            return real
    return path


def _replace_set(place: Path, names: Iterable[str]) -> None:
    """Bring a staged set into its place behind a screen, where one can be made."""
    os.rename(place / PART, place / WHOLE)
    screen, home = None, place
    try:
        screen = _screen(place, names)
        if screen is not None and exchange(place, screen):
            home = screen
        _forward(home)
    except BaseException:
        _backward(home)
        raise
    finally:
        if screen is not None and (home == place or exchange(place, screen)):
            _remove_screen(screen, place)


def _settle(folder: Path) -> None:
    """Keep the promises of a run that was killed, and forget what it had not promised."""
    if (folder / WHOLE).is_dir():
        try:
            _forward(folder)
        except OSError:
            _backward(folder)
            raise
    elif (folder / BACK).is_dir():
        _backward(folder)
    _remove(folder / PART)


def _forward(folder: Path) -> None:
    """Put the files of a promised set into their places; those that are there already stay."""
    whole = folder / WHOLE
    for name in sorted(os.listdir(whole / _NEW)):
        target = _final(folder / name)
        if not target.exists():
            (whole / _ABSENT / name).touch()
        elif not (whole / _FORMER / name).exists():
            _keep(target, whole / _FORMER / name)
        _rename(whole / _NEW / name, target)
    _forget(whole)


def _backward(folder: Path) -> None:
    """Undo `_forward`, however far it came."""
    back = folder / BACK
    if not back.is_dir():
        os.rename(folder / WHOLE, back)
    for name in os.listdir(back / _ABSENT):
        _final(folder / name).unlink(missing_ok=True)
    for name in os.listdir(back / _FORMER):
        _rename(back / _FORMER / name, _final(folder / name))
    _forget(back)


def _forget(promise: Path) -> None:
    """A promise that was kept: one step, for it may not be half gone."""
    part = promise.parent / PART
    _remove(part)
    os.rename(promise, part)
    _remove(part)


def _keep(target: Path, former: Path) -> None:
    """The former file under another name, without taking it away."""
    try:
        os.link(target, former)
    except OSError:  # another disk, or one without links
        half = former.parent.parent / "half"
        shutil.copy2(target, half)
        os.rename(half, former)


def _rename(path: Path, target: Path) -> None:
    """Put a file in the place of another, on another disk too."""
    try:
        os.replace(path, target)
    except OSError as error:
        if not target.parent.is_dir() or path.stat().st_dev == target.parent.stat().st_dev:
            raise
        half = target.with_name(f"{PART}-{hashlib.sha256(os.fsencode(target.name)).hexdigest()[:12]}")
        try:
            shutil.copy2(path, half)
            os.replace(half, target)
        except OSError:
            half.unlink(missing_ok=True)
            raise error from None
        os.unlink(path)


def _screen(place: Path, names: Iterable[str]) -> Path | None:
    """A folder beside this one that looks as it will look; None where that cannot be."""
    published, screen = set(names), beside(place)
    with os.scandir(place) as listed:
        entries = [entry for entry in listed if entry.name != WHOLE]
    if len(entries) > _MOST_ENTRIES or any(entry.is_dir(follow_symlinks=False) for entry in entries):
        return None
    try:
        _mark(screen, published)
        for entry in entries:
            if entry.name not in published:
                os.link(entry.path, screen / entry.name, follow_symlinks=False)
        for name in published:
            os.link(place / WHOLE / _NEW / name, screen / name)
        _as_before(screen, place.stat())
    except (OSError, NotImplementedError):
        _remove_screen(screen, place)
        return None
    return screen


def _mark(screen: Path, names: Iterable[str]) -> None:
    """Begin a screen: a folder that says what it is."""
    os.mkdir(screen)
    (screen / _MARK).write_text(json.dumps(sorted(names)), encoding="ascii")


def _remove_screen(screen: Path, place: Path) -> None:
    """Remove a screen that is not shown; what others put into it meanwhile goes into the folder."""
    with contextlib.suppress(OSError, MemoryError):
        try:
            names = set(json.loads((screen / _MARK).read_text(encoding="ascii")))
        except (OSError, ValueError):  # killed at its beginning
            names = set()
        _remove(screen / PART)
        for name in os.listdir(screen):
            if name in names:
                os.unlink(screen / name)
            elif name != _MARK:
                _give_back(screen / name, place / name)
        (screen / _MARK).unlink(missing_ok=True)
        os.rmdir(screen)


def _give_back(path: Path, target: Path) -> None:
    """An entry of a screen: a link to the folder's own one, or made or changed while the screen was shown."""
    if not os.path.lexists(target):
        os.rename(path, target)
        return
    here, there = os.lstat(path), os.lstat(target)
    if not os.path.samestat(here, there) and here.st_mtime_ns > there.st_mtime_ns:
        os.replace(path, target)
    else:
        os.unlink(path)


def _remove(folder: Path) -> None:
    """Remove a hidden folder of ours; what cannot be removed is left to the next run."""
    with contextlib.suppress(OSError, MemoryError):
        if folder.is_dir():
            shutil.rmtree(folder)
