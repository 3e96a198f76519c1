# SPDX-License-Identifier: MIT
"""A callable held against the right answers, by the library's judge.

The judge is made for a process of its own, and makes one more for the callable: what a crash or a
hang ends is that one alone, which then goes on with the next case. So the caller's process forks:
no other program could ask a callable that only lives here."""
from __future__ import annotations

import contextlib
import json
import os
import re
import signal
import sys
import tempfile
import traceback
from collections.abc import Callable, Iterable
from numbers import Integral, Real
from pathlib import Path
from typing import Any, NamedTuple, NoReturn, Union

import numpy as np

from . import _surehit

Words = Union[str, "Iterable[str]", None]
USAGE = 2  # the status after a complaint of the words


class Verdict(NamedTuple):
    """`str` of it is the judge's table."""
    kept: bool  # what was required
    rows: list[dict[str, Any]]  # one a shape and regime: "cases", "valid", "wrong", "faults", ...
    worst: list[dict[str, Any]]  # one a kind of fault, made simple
    json: dict[str, Any]  # all of `surehit judge --json`
    table: str
    error: str | None  # the traceback of the first exception, which counts as a crash

    def __str__(self) -> str:
        return self.table


def _tell_each(routine: Callable[..., Any], shape: str, rays: Any, objects: Any, statuses: Any,
               hits: Any) -> None:
    for i, (ray, thing) in enumerate(zip(rays, objects)):
        said = routine(shape, ray, thing)
        _tell(np.nan if said is None else said, statuses[i:i + 1], hits[i:i + 1])


def check_masks(name: str, given: Any) -> None:
    """Of what is masked, in lists, too, numpy would take the number behind the mask."""
    if isinstance(given, (list, tuple)):
        for each in given:
            check_masks(name, each)
    elif isinstance(given, np.ma.MaskedArray) and given.mask.any():
        raise ValueError(f"{name}: some of it is masked")


def _check(name: str, values: Any) -> None:
    check_masks(name, values)
    if np.iscomplexobj(values):  # numpy would leave out what is imaginary
        raise TypeError(f"{name}: expected real numbers, not complex ones")
    if name == "part" and (np.asarray(values).astype(np.int32) != values).any():
        raise ValueError(f"part {values!r}: expected parts of the contract")


def _tell(said: Any, statuses: Any, hits: Any) -> None:
    """Writes what the routine has said; on misses the status alone."""
    if hasattr(said, "status"):
        statuses[:] = said.status
        parts = {name: getattr(said, name, None) for name in hits.dtype.names}
    else:
        parts = dict(zip(hits.dtype.names, said if isinstance(said, tuple) else (said,)))
        statuses[:] = np.where(np.isnan(parts["t"]), _surehit.STATUSES.index("miss"),
                               _surehit.STATUSES.index("hit"))
    hit = statuses == _surehit.STATUSES.index("hit")
    for name, values in parts.items():
        if values is not None:
            _check(name, values)
            hits[name][hit] = np.broadcast_to(values, hits[name].shape)[hit]


def _flush() -> None:
    for stream in (sys.stdout, sys.stderr):
        if stream:  # there is none where its file was closed from the start
            stream.flush()


def _asker(routine: Callable[..., Any], each: bool, trouble: Path) -> Callable[..., None]:
    def ask(shape: int, is_float: int, *memory: memoryview) -> None:
        real = np.dtype(np.float32 if is_float else np.float64)
        hit = np.dtype([("t", real), ("part", np.int32), ("normal", real, 3)], align=True)
        statuses, hits = np.frombuffer(memory[2], np.int32), np.frombuffer(memory[3], hit)
        rays, objects = (np.frombuffer(numbers, real).reshape(len(statuses), -1)
                         for numbers in memory[:2])
        name = _surehit.SHAPES[shape]
        try:
            if each:
                _tell_each(routine, name, rays, objects, statuses, hits)
            else:
                _tell(routine(name, rays, objects), statuses, hits)
        except BaseException:
            if not trouble.exists():
                trouble.write_text(traceback.format_exc(), encoding="utf-8")
            _flush()
            os._exit(1)
        _flush()
    return ask


def _word(name: str, value: Any) -> str:
    """A name or a number as the command takes it."""
    if isinstance(value, str):
        if not value or "\0" in value:
            raise ValueError(f"{name}: expected words, not {value!r}")
        return value
    if isinstance(value, bool) or not isinstance(value, Real):
        raise TypeError(f"{name}: expected a name or a number, not {value!r}")
    return str(int(value) if isinstance(value, Integral) else float(value))


def _words(**options: Any) -> list[str]:
    words = []
    for name, given in options.items():
        given = given.tolist() if isinstance(given, np.ndarray) else given
        one = isinstance(given, (str, bytes)) or not isinstance(given, Iterable)
        several = [given] if one else list(given)
        if not several:  # the command would take it for all
            raise ValueError(f"{name}: expected at least one, or None")
        for value in several if given is not None else ():
            option = "--" + name.removeprefix("case_").replace("_", "-")
            words += [option, _word(name, value)]
    return words


def _name_of(routine: Callable[..., Any]) -> str:
    name = getattr(routine, "__name__", None)
    shown = name if isinstance(name, str) else type(routine).__name__
    return shown.encode(errors="replace").decode().replace("\0", "?")


def _live(ask: Callable[..., None], name: str, words: list[str], folder: Path) -> NoReturn:
    """The judge's process."""
    status = USAGE
    try:
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # whoever waits for it ends it
        for number, file in (1, "table"), (2, "said"):
            os.dup2(os.open(folder / file, os.O_WRONLY | os.O_CREAT | os.O_APPEND), number)
        status = _surehit.judge(ask, name, tuple(words))
        (folder / "status").write_text(str(status), encoding="ascii")
    except BaseException:
        os.write(2, traceback.format_exc().encode())
    finally:
        os._exit(status)


def _wait_for(process: int, folder: Path) -> int | None:
    """Its status, None where nobody knows."""
    try:
        return os.waitstatus_to_exitcode(os.waitpid(process, 0)[1])
    except ChildProcessError:  # it has ended; who ignores SIGCHLD is not told how
        status = _read(folder / "status")
        return int(status) if status else None
    except BaseException:
        with contextlib.suppress(ProcessLookupError, ChildProcessError):
            os.kill(process, signal.SIGKILL)
            os.waitpid(process, 0)
        raise


def _read(path: Path) -> str:
    return path.read_text(encoding="utf-8", errors="replace") if path.exists() else ""


def _complaint(said: str) -> str:
    """By the names of arguments."""
    said = said.strip().removeprefix("surehit judge: error: ").partition("; see '")[0]
    return re.sub(r"^--([\w-]+)", lambda option: "case_set" if option[1] == "set" else
                  option[1].replace("-", "_"), said)


def _answered(rows: list[dict[str, Any]]) -> int:
    lost = "crash", "no answer in time", "no answer"
    return sum(row["cases"] - sum(row["faults"][name] for name in lost) for row in rows)


def _verdict(status: int | None, folder: Path) -> Verdict:
    said, error = _read(folder / "said"), _read(folder / "trouble") or None
    found = json.loads(_read(folder / "json") or "null")
    if found is None and status == USAGE and not error:
        raise ValueError(_complaint(said))
    if found is None and not error:
        raise RuntimeError(f"the judge ended with status {status}: {said.strip()}")
    if found is None or (error and _answered(found["rows"]) == 0):
        raise RuntimeError(f"the routine never answered, and first raised\n{error}")
    if sys.stderr:
        sys.stderr.write(said)
    table = re.sub(r"(?m)^  echo '([^'#]*?)(?: # \w+)?' \| .*$", r"  case    \1",
                   _read(folder / "table"))  # a command could not ask again
    return Verdict(status == 0, found["rows"], found["worst"], found, table, error)


def judge(routine: Callable[..., Any], *, each: bool = False, shape: Words = None,
          regime: Words = None, count: int | None = None, seed: int | None = None,
          case_set: str | None = None, inputs: str = "double", entry: str | None = None,
          margin: str | None = None, require: str | None = None,
          time_limit: float | np.floating[Any] | None = None) -> Verdict:
    """Asks `routine` the judge's cases and holds its answers against the exact ones.

    routine  routine(shape, rays, objects) for arrays (n, 8) and (n, N) as `cases` has them. It
             returns t, NaN where the ray misses; or (t, part) or (t, part, normal); or what `hits`
             returns. Of the parts PARTS has the names.
    each     routine(shape, ray, object) is called case by case, and may return None for a miss.
    inputs   "float": the arrays are float32, and the answers are judged as floats.

    The other words are those of `surehit judge`: docs/judge.md says what they mean. An exception
    counts as a crash in the case that raises it; if nothing else comes it is a RuntimeError."""
    if not callable(routine):
        raise TypeError(f"routine: expected a callable, not {routine!r}")
    options = _words(shape=shape, regime=regime, count=count, seed=seed, case_set=case_set,
                     inputs=inputs, entry=entry, margin=margin, require=require,
                     time_limit=time_limit)
    with tempfile.TemporaryDirectory(prefix="surehit-") as name:
        folder = Path(name)
        words = ["surehit judge", "--candidate", _surehit.__file__, "--json",
                 str(folder / "json"), *options]
        ask = _asker(routine, each, folder / "trouble")
        _flush()
        process = os.fork()
        if process == 0:
            _live(ask, _name_of(routine), words, folder)
        return _verdict(_wait_for(process, folder), folder)
