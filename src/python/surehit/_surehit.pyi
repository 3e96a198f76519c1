# SPDX-License-Identifier: MIT
"""The extension. Shapes, tiers and regimes are their numbers in the tuples of names here."""
from typing import Any, Callable


SHAPES: tuple[str, ...]
TIERS: tuple[str, ...]
PARTS: tuple[str, ...]
STATUSES: tuple[str, ...]
REGIMES: tuple[str, ...]
VERSION: str

def fields(shape: int) -> tuple[tuple[str, int], ...]: ...
def applies(shape: int, regime: int) -> bool: ...
def check(shape: int, numbers: tuple[float, ...]) -> str: ...
def hits(shape: int, tier: int, inputs: tuple[Any, ...],
         outputs: tuple[Any, ...]) -> None:
    """Arrays of doubles, of one shape but for a last axis: all together hold the numbers of a ray
    and its object. Outputs are of that shape, the sixth with a last axis of 3: status and part 'B',
    leaves '?', t, t_error and normal 'd'; of all but the first None is not wanted."""
def cases(shape: int, regime: int, seed: int, first: int, numbers: Any) -> None:
    """Fills the doubles, so many for a case as it has."""
def judge(ask: Callable[[int, int, memoryview, memoryview, memoryview, memoryview], object],
          name: str, words: tuple[str, ...]) -> int:
    """`surehit judge` by these words, of which --candidate names this very file. Its exit status.
    Once in a process."""
