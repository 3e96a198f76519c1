#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the cases of a file of vectors with their answers (docs/vectors.md): vectors.py FILE

Behind "or" is the other decision where a touch may be a miss, or where it turns within a tolerance
of 1e-9 of the object's size."""
import json
import sys


def vectors(path):
    with open(path, "rb") as file:
        head, body = json.loads(file.readline()), file.read()
    digest = 0xcbf29ce484222325
    for byte in body:
        digest = (digest ^ byte) * 0x100000001b3 % 2**64
    if head["surehit_vectors"] != 2 or head["digest"] != f"{digest:016x}":
        sys.exit(f"{path}: another version, or spoiled")
    return [json.loads(line) for line in body.splitlines()]


for vector in vectors(sys.argv[1]):
    numbers = [float.fromhex(number) for number in vector["case"]]
    t = [float.fromhex(vector["t"])] if vector["answer"] == "hit" else []
    other = "miss" if vector["answer"] == "hit" else "hit"
    may_be = vector.get("margin", {}).get(other, 1) <= 1e-9 or vector.get("event") == "touch"
    print(*numbers, ":", vector["answer"], *t, *["or", other] * may_be)
