"""Do the tests notice? Each *.mutant file beside this one is a deliberate bug in one source file:

    stem: sphere                    its test, test_sphere, has to fail
    source: src/intersect/sphere.c
    erratum: E14                    docs/errata.md's id, where it is the notes' printed form
    why: one line
    --- right
    lines that occur exactly once in the source
    --- wrong
    what replaces them

The sources that the change reaches are compiled anew into a library that is loaded before the real
one, so that the test programs run as they were built. A mutant is caught when its test fails an
assertion; a crash, a hang or a compiler's error is no catch.
"""

import argparse
import concurrent.futures
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

# A shape's test is long, so its parts are run one by one until one of them fails.
PARTS = dict.fromkeys(['plane', 'disc', 'sphere', 'cylinder', 'cone'], ['hard', 'world', 'laws'])
WORLD_SHARE = '7'  # every seventh member of the small world
SECONDS = 120
PROCESSES = 2


class Broken(Exception):
    """Why a mutant cannot be judged or is not caught."""


class Mutant:
    def __init__(self, path):
        self.name = path.stem
        head, right, wrong = self.split(path.read_text())
        fields = dict(line.split(': ', 1) for line in head.splitlines())
        self.stem = fields.pop('stem', '')
        self.source = fields.pop('source', '')
        self.why = fields.pop('why', '')
        self.errata = fields.pop('erratum', '').split()
        if fields or not (self.stem and self.source and self.why):
            raise Broken('the head is stem, source, erratum (optional), why')
        if not self.name.startswith(self.stem + '-'):
            raise Broken('its name has to begin with its stem')
        self.right, self.wrong = right, wrong

    @staticmethod
    def split(text):
        parts = re.fullmatch(r'(.*?)--- right\n(.+?\n)--- wrong\n(.*)', text, re.DOTALL)
        if not parts:
            raise Broken('no "--- right" and "--- wrong" blocks')
        return parts.groups()

    def apply(self, text):
        if text.count(self.right) != 1:
            raise Broken(f'does not apply: {text.count(self.right)} places in {self.source}')
        return text.replace(self.right, self.wrong)


class Build:
    """Compiles what a changed source reaches."""

    def __init__(self, options):
        self.root = options.root.resolve()
        self.scratch = options.scratch.resolve()
        self.tiers = [self.relative(path) for path in options.tiers]
        self.once = [self.relative(path) for path in options.once]
        self.command = options.compiler + ['-std=c11', '-O1', '-fPIC', '-shared', '-w',
                                           f'-I{self.root}/include']
        self.reached = {source: self.includes(source) for source in self.tiers + self.once}
        shutil.rmtree(self.scratch, ignore_errors=True)

    def relative(self, path):
        return path.resolve().relative_to(self.root).as_posix()

    def includes(self, source):
        found, rest = set(), [source]
        while rest:
            name = rest.pop()
            if name in found:
                continue
            found.add(name)
            text = (self.root / name).read_text()
            for header in re.findall(r'^#include "(.+)"', text, re.MULTILINE):
                rest.append(self.relative(self.root / name / '..' / header))
        return found

    def libraries(self, name, source, text):
        """The libraries, one a precision, in which `source` reads `text`; None for no change."""
        folder = self.scratch / name
        shutil.copytree(self.root / 'src', folder / 'src')
        if source:
            (folder / source).write_text(text)
        made = []
        for library, files, flags in (('double.so', self.tiers + self.once, []),
                                      ('float.so', self.tiers, ['-DSURE_FLOAT32'])):
            files = [file for file in files if source is None or source in self.reached[file]]
            if not files:
                continue
            made.append(str(folder / library))
            run = subprocess.run(self.command + flags + files + ['-o', made[-1], '-lm'], cwd=folder,
                                 capture_output=True, text=True)
            if run.returncode != 0:
                errors = re.findall(r'^.*error.*$', run.stderr, re.MULTILINE) or [run.stderr]
                raise Broken('does not compile: ' + errors[0].strip())
        if not made:
            raise Broken(f'{source} reaches no source of the library')
        return made


def parts_that_fail(program, stem, libraries):
    """The test cases of the stem's test that fail an assertion; empty when all pass."""
    for part in PARTS.get(stem, [None]):
        environment = dict(os.environ, CK_FORK='no', LD_PRELOAD=' '.join(libraries),
                           SUREHIT_WORLD_SHARE=WORLD_SHARE)
        environment.pop('CK_RUN_CASE', None)
        if part:
            environment['CK_RUN_CASE'] = part
        try:
            run = subprocess.run([program], env=environment, capture_output=True, text=True,
                                 errors='replace', timeout=SECONDS)
        except subprocess.TimeoutExpired:
            raise Broken(f'{program.name} hangs') from None
        except OSError as error:
            raise Broken(f'{program.name}: {error.strerror}') from None
        failed = re.findall(r'^\S+:\d+:F:([^:]*):', run.stdout, re.MULTILINE)
        if run.returncode not in (0, 1) or (run.returncode == 1) != bool(failed):
            raise Broken(f'{program.name} ends with status {run.returncode}, not by an assertion')
        if failed:
            return list(dict.fromkeys(failed))
    return []


def judge(mutant, build, programs):
    """The test cases that catch the mutant."""
    source = build.root / mutant.source
    if not source.is_file():
        raise Broken(f'no such source: {mutant.source}')
    try:
        libraries = build.libraries(mutant.name, mutant.source, mutant.apply(source.read_text()))
        caught = parts_that_fail(programs / f'test_{mutant.stem}', mutant.stem, libraries)
    finally:
        shutil.rmtree(build.scratch / mutant.name, ignore_errors=True)
    if not caught:
        raise Broken('SURVIVES')
    return caught


def judge_unchanged(stem, libraries, programs):
    """The way of judging is sound only if it finds nothing where nothing is wrong."""
    failed = parts_that_fail(programs / f'test_{stem}', stem, libraries)
    if failed:
        raise Broken('fails without any mutant: ' + ', '.join(failed))
    return ['nothing, rightly']


def errata_differences(errata, mutants):
    """What the table of docs/errata.md and the mutants say differently of one another."""
    by_name = {mutant.name: mutant for mutant in mutants}
    rows = re.findall(r'^\| (E\d+) \|.*\| ([^|]*) \|$', errata.read_text(), re.MULTILINE)
    for erratum, carriers in rows:
        for name in re.findall(r'`(\w+-[\w-]+)`', carriers):
            if name not in by_name:
                yield f'{erratum}: no mutant {name}'
            elif erratum not in by_name[name].errata:
                yield f'{erratum}: {name} is not marked as this erratum'
    ids = {erratum for erratum, _ in rows}
    for mutant in mutants:
        yield from (f'{mutant.name}: no erratum {e}' for e in mutant.errata if e not in ids)
    if not rows:
        yield f'{errata}: no table of errata'


def read_mutants(folder, chosen):
    mutants, complaints = [], []
    for path in sorted(folder.glob('*.mutant')):
        try:
            mutants.append(Mutant(path))
        except (Broken, ValueError) as error:
            complaints.append(f'{path.name}: {error}')
    if chosen:
        mutants = [mutant for mutant in mutants if mutant.name in chosen or mutant.stem in chosen]
    return mutants, complaints


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--root', type=Path, required=True, help='the project')
    parser.add_argument('--scratch', type=Path, required=True, help='a folder to build in')
    parser.add_argument('--programs', type=Path, required=True, help='where the tests are built')
    parser.add_argument('--tiers', type=Path, nargs='+', required=True,
                        help='sources compiled once a precision')
    parser.add_argument('--once', type=Path, nargs='+', required=True, help='the other sources')
    parser.add_argument('--only', nargs='+', help='mutants or stems')
    parser.add_argument('compiler', nargs='+', help='after --: the compiler and its flags')
    options = parser.parse_args()

    folder = options.root / 'tests' / 'mutants'
    mutants, complaints = read_mutants(folder, options.only)
    if not options.only:
        complaints += errata_differences(options.root / 'docs' / 'errata.md', mutants)
    build = Build(options)
    programs = options.programs.resolve()
    try:
        unchanged = build.libraries('unchanged', None, None)
    except Broken as error:
        sys.exit(f'the sources as they are: {error}')
    with concurrent.futures.ThreadPoolExecutor(PROCESSES) as pool:
        jobs = [(f'({stem} unchanged)', pool.submit(judge_unchanged, stem, unchanged, programs))
                for stem in sorted({mutant.stem for mutant in mutants})]
        jobs += [(mutant.name, pool.submit(judge, mutant, build, programs)) for mutant in mutants]
        for name, job in jobs:
            try:
                print(f'{name:40} {", ".join(job.result())}', flush=True)
            except Broken as error:
                print(f'{name:40} {error}', flush=True)
                complaints.append(f'{name}: {error}')
    shutil.rmtree(build.scratch, ignore_errors=True)
    print(f'{len(mutants)} mutants, {len(complaints)} complaints')
    for complaint in complaints:
        print(f'  {complaint}')
    return 1 if complaints or not mutants else 0


if __name__ == '__main__':
    sys.exit(main())
