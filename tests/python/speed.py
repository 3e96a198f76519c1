#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a ray costs in Python above C: speed.py LIBRARY [COUNT [--most NS]]

The package's `hits` beside the library's own call for many rays, of LIBRARY (libsurehit.so), on the
same arrays, in turns, with all answers wanted, by tier certain. A row a shape: nanoseconds of rays
of the regime typical and one object in C, and how much more Python takes: into new arrays, into
given ones, for float32; and for pairs, likewise. Exit status 1: more than --most (20) above C."""
import ctypes
import sys
import time

import numpy as np
import surehit

MOST = 20  # ns a ray above C
ROUNDS = 15


class Column(ctypes.Structure):
    _fields_ = [("first", ctypes.c_void_p), ("stride", ctypes.c_ssize_t)]


def column(array):
    return Column(array.ctypes.data, array.strides[0] if array.ndim else 0)


def columns(arrays):
    return (Column * len(arrays))(*map(column, arrays))


class Asked:
    """`count` rays by the library itself; the objects' rows, or all of the first."""

    def __init__(self, library, shape, rays, objects, pairs):
        self.count, self.out = len(rays), surehit.hits(shape, rays, objects, invalid="answer")
        self.rays = columns(list(rays.T))
        out = self.out
        self.hits = columns([out.status, out.part, out.leaves, out.t, out.t_error, *out.normal.T])
        self.object = objects if pairs else np.ascontiguousarray(objects)
        if pairs:
            self.call = library.sure_objects_hits
            self.of = (ctypes.c_char * (8 + 7 * 16))()
            ctypes.c_int.from_buffer(self.of).value = surehit.SHAPES.index(shape)
            whole = columns(list(objects.T))
            ctypes.memmove(ctypes.addressof(self.of) + 8, whole, ctypes.sizeof(whole))
            self.tier = [ctypes.c_int(surehit.TIERS.index("certain"))]
        else:
            self.call = library[f"sure_{shape}_hits_certain"]
            self.of, self.tier = ctypes.c_void_p(self.object.ctypes.data), []
        self.call.restype = None

    def __call__(self):
        self.call(ctypes.c_size_t(self.count), self.rays, self.of, *self.tier, self.hits)


def nanoseconds(calls, count):
    """Processor time of the first, and how much more the others take: what another program's load
    adds is never less than nothing, so the least of the rounds counts."""
    took = [[] for _ in calls]
    for _ in range(ROUNDS):
        for call, times in zip(calls, took):
            before = time.thread_time_ns()
            call()
            times.append((time.thread_time_ns() - before) / count)
    first, *others = map(min, took)
    return first, [other - first for other in others]


def main():
    library = ctypes.CDLL(sys.argv[1])
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 50000
    most = float(sys.argv[4]) if len(sys.argv) > 4 else MOST
    print(f"{'shape':<10}{'C':>8}{'new':>8}{'given':>8}{'float32':>8}{'C pairs':>10}{'new':>8}")
    worst = -np.inf
    for shape in surehit.SHAPES:
        rays, objects = surehit.cases(shape, "typical", count)
        one = objects[0]
        out = surehit.hits(shape, rays, one, invalid="answer")
        single = rays.astype(np.float32), one.astype(np.float32)
        in_c, more = nanoseconds(
            [Asked(library, shape, rays, one, False),
             lambda: surehit.hits(shape, rays, one, invalid="answer"),
             lambda: surehit.hits(shape, rays, one, invalid="answer", out=out),
             lambda: surehit.hits(shape, *single, invalid="answer")], count)
        of_pairs, by_pairs = nanoseconds(
            [Asked(library, shape, rays, objects, True),
             lambda: surehit.hits(shape, rays, objects, invalid="answer")], count)
        figures = in_c, *more, of_pairs, *by_pairs
        print(f"{shape:<10}" + "".join(f"{figure:{10 if i == 4 else 8}.1f}"
                                       for i, figure in enumerate(figures)))
        worst = max(worst, *more, *by_pairs)
    print(f"above C at most {worst:.1f} ns a ray: {'holds' if worst <= most else 'MORE THAN'} "
          f"{most:g}")
    return worst > most


sys.exit(main())
