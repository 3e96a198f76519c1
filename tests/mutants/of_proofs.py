# SPDX-License-Identifier: MIT
"""Mutants of what docs/proofs proves. The stems adjoint, coarse and expressions are programs of
tests/proofs, made of the filters' headers. Mutants of the stem proofs change a constant, and Gappa
judges the scripts that name it."""

import shutil
import subprocess
import sys

PROGRAMS = ['adjoint', 'coarse', 'expressions']  # without Check
EFFORT = {'adjoint': '12', 'coarse': '60000'}  # climbs and cases: fewer than the tests take


def available(programs):
    """The stems that can be judged here."""
    return {*(['proofs'] if shutil.which('gappa') else []), *(set(PROGRAMS) & set(programs))}


def command(root, stem, program):
    scripts = sorted((root / 'docs/proofs').glob('*.gappa'))
    if stem in EFFORT:
        return [program, EFFORT[stem]]
    return [sys.executable, '-B', root / 'tests/proofs/test_proofs.py', stem, root, program,
            *scripts]


def judge(root, folder, mutant, source, text):
    """The scripts that Gappa does not prove when `source` has this text."""
    for part in ('include', 'src', 'docs/proofs', 'tests/proofs'):
        shutil.copytree(root / part, folder / part)
    (folder / source).write_text(text)
    named = [script for script in sorted((folder / 'docs/proofs').glob('*.gappa'))
             if mutant.place in script.read_text()]
    failed = [script.stem for script in named if subprocess.run(
        [sys.executable, folder / 'tests/proofs/test_proofs.py', 'prove', shutil.which('gappa'),
         folder, script], capture_output=True).returncode == 1]
    shutil.rmtree(folder)
    return failed
