"""Mutants of what docs/proofs proves. The stems adjoint, coarse and expressions are programs of
tests/proofs, made of the filters' headers. Mutants of the stem proofs change a constant, and Gappa
judges the scripts that name it."""

import re
import shutil
import subprocess
import sys

from mutant import Broken

STEMS = ['adjoint', 'coarse', 'expressions', 'proofs']
EFFORT = {'adjoint': '12', 'coarse': '60000'}  # climbs and cases: fewer than the tests take
FOLDERS = ['include', 'src', 'docs/proofs', 'tests/proofs']


def copy(build, name, source, text):
    """A folder with all that is needed, `source` with this text."""
    folder = build.scratch / name
    for part in FOLDERS:
        shutil.copytree(build.root / part, folder / part)
    if source:
        (folder / source).write_text(text)
    return folder


def program(build, stem, folder):
    """The stem's program, made of the folder's headers."""
    made, extra = folder / stem, []
    if stem == 'coarse':
        bounds = subprocess.run([sys.executable, folder / 'tests/proofs/coarse_bounds.py',
                                 folder / 'include/surehit/bounds.h'], check=True,
                                capture_output=True, text=True).stdout
        (folder / 'coarse_bounds.h').write_text(bounds)
        build.run(build.command + ['-c', str(folder / 'tests/proofs/truth.c')], folder)
        extra = ['truth.o', str(build.scratch / 'unchanged' / 'library.so'), '-lgmp', '-lm']
    build.run(build.cxx + ['-std=c++17', '-O1', '-w', '-ffp-contract=off', '-I.', '-Iinclude',
                           '-Isrc', f'tests/proofs/{stem}.cpp', '-o', str(made), *extra], folder)
    return made


def ask(folder, what, *args):
    """Whether test_proofs.py is content, and what it says."""
    run = subprocess.run([sys.executable, folder / 'tests/proofs/test_proofs.py', what, *args],
                         capture_output=True, text=True)
    return run.returncode == 0, run.stdout.splitlines()


def faults(build, stem, folder, constant):
    """What the stem's test finds wrong in the folder."""
    scripts = sorted((folder / 'docs/proofs').glob('*.gappa'))
    if stem == 'proofs':
        named = [script for script in scripts if constant and constant in script.read_text()]
        return [script.stem for script in named
                if not ask(folder, 'prove', shutil.which('gappa'), folder, script)[0]]
    made = program(build, stem, folder)
    if stem == 'expressions':
        content, said = ask(folder, stem, folder, made, *scripts)
        if not content and not said:
            raise Broken(f'{stem} ends without a word')
        return [] if content else sorted({line.split(':')[0] for line in said[:-1]})
    run = subprocess.run([made, EFFORT[stem]], capture_output=True, text=True)
    failed = list(dict.fromkeys(re.findall(r'^\S+:\d+:F:([^:]*):', run.stdout, re.M)))
    if run.returncode not in (0, 1) or (run.returncode == 1) != bool(failed):
        raise Broken(f'{stem} ends with status {run.returncode}, not by an assertion')
    return failed
