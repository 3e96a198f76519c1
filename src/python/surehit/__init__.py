# SPDX-License-Identifier: MIT
"""Ray-surface intersections whose answers can be trusted, for many rays at once.

`hits` answers for arrays of rays and objects, `cases` makes hard ones, and `judge` holds anybody's
routine against the right answers. What the words mean is on the pages of surehit's contract."""
from __future__ import annotations

from operator import index
from typing import Any, Iterable, NamedTuple, NoReturn, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _surehit
from ._judge import Verdict, check_masks, judge
from ._surehit import PARTS, REGIMES, SHAPES, STATUSES, TIERS

__all__ = ["FIELDS", "HIT", "INVALID", "MISS", "NO_PART", "PARTS", "REGIMES", "SHAPES", "STATUSES",
           "TIERS", "Cases", "Hits", "Verdict", "cases", "hits", "judge"]
__version__ = _surehit.VERSION

MISS, HIT, INVALID = map(STATUSES.index, ("miss", "hit", "invalid"))
NO_PART = 255  # where there is no hit

# Of each shape its fields and how many numbers each is: {"sphere": (("centre", 3), ...), ...}
FIELDS = {name: _surehit.fields(number) for number, name in enumerate(SHAPES)}

_RAY = (("origin", 3), ("direction", 3), ("t_min", 1), ("t_max", 1))
_RAY_DEFAULTS = (0.0, np.inf)  # of t_min and t_max

Doubles = npt.NDArray[np.float64]
Numbers = Union[npt.ArrayLike, "tuple[npt.ArrayLike, ...]"]


class Hits(NamedTuple):
    """Arrays of one shape; `normal` has one axis more, of 3. Where there is no hit `part` is
    NO_PART and numbers are NaN."""
    status: npt.NDArray[np.uint8]  # MISS, HIT or INVALID
    part: npt.NDArray[np.uint8]  # PARTS has their names
    leaves: npt.NDArray[np.bool_]  # the ray comes from a solid's inside
    t: Doubles
    t_error: Doubles
    normal: Doubles | None  # None where it was not asked for


class Cases(NamedTuple):
    rays: Doubles  # origin, direction, t_min, t_max
    objects: Doubles  # the shape's fields


def _number(name: str, word: str, words: Sequence[str]) -> int:
    if not isinstance(word, str):
        raise TypeError(f"{name}: expected a name, not {word!r}")
    if word not in words:
        raise ValueError(f"{name} {word!r}: expected one of {', '.join(words)}")
    return words.index(word)


def _of_objects(name: str, objects: npt.NDArray[Any], array: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """Of a list that mixes whole numbers with others numpy has rounded them before."""
    for number in objects.flat:
        if isinstance(number, (int, np.integer)):
            try:
                same = float(number) == int(number)  # numpy's would be rounded before
            except OverflowError:
                same = False
            if not same:
                raise ValueError(f"{name}: a whole number that is no double")
        elif not isinstance(number, (float, np.floating)):
            return array
    return objects.astype(np.float64) if array.dtype.kind == "O" else array


def _doubles(name: str, given: npt.ArrayLike) -> Doubles:
    """The very numbers: floats are doubles, and so are most whole numbers."""
    try:
        array = np.asarray(given)
    except ValueError as error:
        raise ValueError(f"{name}: {error}") from None
    if array.dtype.kind in "fiu":
        check_masks(name, given)
    if not isinstance(given, np.ndarray) and array.dtype.kind in "fO":
        array = _of_objects(name, np.asarray(given, dtype=object), array)
    if array.dtype.kind == "f" and array.itemsize <= 8:
        return array.astype(np.float64, copy=False)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name}: expected numbers that are doubles, not {array.dtype}")
    doubles = array.astype(np.float64)
    beyond = float(int(np.iinfo(array.dtype).max) + 1)  # some processors make of it the last one
    with np.errstate(invalid="ignore"):
        if (doubles >= beyond).any() or (doubles.astype(array.dtype) != array).any():
            raise ValueError(f"{name}: a whole number that is no double")
    return doubles


def _sized(name: str, given: npt.ArrayLike, sizes: Sequence[int]) -> Doubles:
    array = _doubles(name, given)
    if array.ndim == 0 or array.shape[-1] not in sizes:
        expected = " or ".join(map(str, sizes))
        raise ValueError(f"{name}: expected a last axis of {expected}, not shape {array.shape}")
    return array


def _columns(name: str, given: Numbers, fields: Sequence[tuple[str, int]],
             defaults: Sequence[float] = ()) -> list[Doubles]:
    """Arrays with a last axis for their numbers: one array of all fields, or one a field."""
    least, most = len(fields) - len(defaults), len(fields)
    if not isinstance(given, tuple):
        sizes = sorted({sum(size for _, size in fields[:count]) for count in (least, most)})
        arrays = [_sized(name, given, sizes)]
        missing = arrays[0].shape[-1] < sizes[-1]
    elif least <= len(given) <= most:
        arrays = [_sized(f"{name}: {field}", part, [size]) if size > 1 else
                  _doubles(f"{name}: {field}", part)[..., np.newaxis]
                  for (field, size), part in zip(fields, given)]
        missing = len(given) < most
        defaults = defaults[len(given) - least:]
    else:
        raise ValueError(f"{name}: expected a tuple of {', '.join(field for field, _ in fields)}, "
                         f"not of {len(given)}; numbers in one array are an array or a list")
    return [*arrays, np.array(defaults, np.float64)] if missing else arrays


def _common_shape(rays: Iterable[Doubles], objects: Iterable[Doubles]) -> tuple[int, ...]:
    shapes = []
    for name, arrays in ("rays", rays), ("objects", objects):
        shapes.append([array.shape[:-1] for array in arrays])
        try:
            np.broadcast_shapes(*shapes[-1])
        except ValueError:
            raise ValueError(f"{name}: shapes that don't go together: "
                             f"{', '.join(map(str, shapes[-1]))}") from None
    try:
        return np.broadcast_shapes(*shapes[0], *shapes[1])
    except ValueError:
        one, other = (np.broadcast_shapes(*each) for each in shapes)
        raise ValueError(f"objects: their shape {other} does not go with the rays' {one}") from None


# Of each array of Hits what it holds, and an axis of its own.
_LAYOUT: tuple[tuple[str, Any, tuple[int, ...]], ...] = (
    ("status", np.uint8, ()), ("part", np.uint8, ()), ("leaves", np.bool_, ()),
    ("t", np.float64, ()), ("t_error", np.float64, ()), ("normal", np.float64, (3,)))


def _made(shape: tuple[int, ...], normals: bool) -> Hits:
    *made, normal = (np.empty((*shape, *own), kind) for _, kind, own in _LAYOUT)
    return Hits._make((*made, normal if normals else None))


def _overlaps_itself(array: npt.NDArray[Any]) -> bool:
    """No axis may begin within what those of smaller strides cover."""
    covered = array.itemsize
    for stride, size in sorted((abs(stride), size) for stride, size in
                               zip(array.strides, array.shape) if size > 1):
        if stride < covered:
            return array.size > 0
        covered += stride * (size - 1)
    return False


def _check_out(out: Hits, shape: tuple[int, ...], inputs: Sequence[Doubles]) -> None:
    if not isinstance(out, Hits):
        raise TypeError(f"out: expected Hits, not {type(out).__name__}")
    taken: list[tuple[str, Any]] = [("what is asked", each) for each in inputs]
    for (name, kind, own), array in zip(_LAYOUT, out):
        if array is None and name == "normal":
            continue
        if not isinstance(array, np.ndarray) or array.dtype != kind:
            raise TypeError(f"out.{name}: expected an array of {kind.__name__}")
        if array.shape != (*shape, *own) or not array.flags.writeable:
            raise ValueError(f"out.{name}: expected a writeable array of shape {(*shape, *own)}, "
                             f"not {array.shape}")
        if _overlaps_itself(array):
            raise ValueError(f"out.{name}: several of its elements are one")
        for other, there in taken:
            if np.shares_memory(array, there):
                raise ValueError(f"out.{name}: shares memory with {other}")
        taken.append((f"out.{name}", array))


def _clear(out: Hits) -> None:
    out.part.fill(NO_PART)
    out.leaves.fill(False)
    for numbers in (out.t, out.t_error, out.normal):
        if numbers is not None:
            numbers.fill(np.nan)


def _refuse(shape: str, of_rays: Sequence[Doubles], of_objects: Sequence[Doubles],
            columns: Sequence[Doubles], status: npt.NDArray[np.uint8]) -> NoReturn:
    """Names the first that is invalid, by its place in what was given."""
    place = tuple(int(i) for i in np.argwhere(status == INVALID)[0])
    numbers = tuple(float(x) for column in columns for x in column[place])
    field = _surehit.check(SHAPES.index(shape), numbers)
    name, given = ("objects", of_objects) if field in dict(FIELDS[shape]) else ("rays", of_rays)
    own = np.broadcast_shapes(*(array.shape[:-1] for array in given))
    own_place = [0 if size == 1 else i for size, i in zip(own, place[len(place) - len(own):])]
    at = f"[{', '.join(map(str, own_place))}]" if own else ""
    raise ValueError(f"{name}{at}: invalid {field}; with invalid='answer' its status says so")


def hits(shape: str, rays: Numbers, objects: Numbers, tier: str = "certain", *,
         normals: bool = True, invalid: str = "raise", out: Hits | None = None) -> Hits:
    """Where each ray first meets its object.

    rays     an array (..., 8) of origin, direction, t_min, t_max, or (..., 6) without the last two,
             which are 0 and infinity then; or a tuple of two to four arrays, one each.
    objects  an array (..., N) of the shape's numbers (FIELDS), or a tuple of an array a field.
    invalid  "raise": a ray or object that the contract calls invalid is an error; "answer": its
             status is INVALID.
    out      Hits whose arrays are written and returned, instead of new ones.

    The axes before the last are broadcast: many rays and one object, one ray and many objects,
    pairs, all with all. Every answer is the library's for that ray alone, bit by bit."""
    which, how = _number("shape", shape, SHAPES), _number("tier", tier, TIERS)
    _number("invalid", invalid, ("raise", "answer"))
    of_rays = _columns("rays", rays, _RAY, _RAY_DEFAULTS)
    of_objects = _columns("objects", objects, FIELDS[shape])
    common = _common_shape(of_rays, of_objects)
    columns = [array if array.shape[:-1] == common else
               np.broadcast_to(array, (*common, array.shape[-1]))
               for array in (*of_rays, *of_objects)]
    if out is None:
        out = _made(common, normals)
    else:
        _check_out(out, common, columns)
    _clear(out)
    _surehit.hits(which, how, tuple(columns), tuple(out))
    if invalid == "raise" and (out.status == INVALID).any():
        _refuse(shape, of_rays, of_objects, columns, out.status)
    return out


def _whole(name: str, number: Any, least: int = 0) -> int:
    try:
        whole = index(number)
    except TypeError:
        raise TypeError(f"{name}: expected a whole number, not {number!r}") from None
    if not least <= whole < 2**63:
        raise ValueError(f"{name}: expected a whole number from {least} to 2**63 - 1, not {whole}")
    return whole


def cases(shape: str, regime: str, count: int, seed: int = 0, first: int = 0) -> Cases:
    """Cases `first`, `first` + 1, ... of a regime, as `surehit cases` has them on every machine."""
    which, kind = _number("shape", shape, SHAPES), _number("regime", regime, REGIMES)
    if not _surehit.applies(which, kind):
        raise ValueError(f"regime {regime!r}: the {shape} has none")
    ray = sum(size for _, size in _RAY)
    numbers = np.empty((_whole("count", count), ray + sum(size for _, size in FIELDS[shape])))
    _surehit.cases(which, kind, _whole("seed", seed), _whole("first", first), numbers)
    return Cases(numbers[:, :ray], numbers[:, ray:])
