"""Do the tests notice? Each entry of the *.mutants files beside this one (mutant.py says how they
read) is a deliberate bug in one function.

The sources that the change reaches are compiled anew, in every variant that src/meson.build has of
them, and with the others make a library that is loaded before the real one, so that the test
programs run as they were built. What lies in a header alone, or in the tracer, is part of its test,
which is compiled anew. A mutant is caught when its test fails an assertion; a crash, a hang or a
compiler's error is no catch.
"""

import argparse
import concurrent.futures
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import of_proofs
from mutant import Broken, Sources, read

# These tests are long, so their parts are run one by one, the quick ones first, until one fails.
PARTS = dict.fromkeys(['plane', 'disc', 'sphere', 'cylinder', 'cone'],
                      ['hard', 'truth', 'world', 'laws'])
PARTS['bvh'] = ['box', 'walk', 'hits', 'build', 'visible']
PARTS['mixed'] = ['map', 'eye']
PARTS['forward'] = ['random', 'direction', 'law 1', 'law 2', 'dark', 'entering', 'covered opening',
                    'no power', 'lights', 'box', 'sheet', 'glass ball', 'ball in a ball', 'floor',
                    'mirror', 'ball', 'openings', 'law 3', 'ball, open', 'ball, lit from beside']
# Tests that are compiled anew, and sources that are then part of them.
IN_TESTS = dict.fromkeys(['ddb', 'dd', 'mod128'], [])
IN_TESTS['bvh'] = ['tests/support/box_truth.c', 'src/hierarchy/bvh_box.c'] + [
    f'src/tracer/{name}.c' for name in ['statistics', 'backward', 'meeting', 'scene', 'shadow',
                                        'visible']]
IN_TESTS['bvh'] += ['src/hierarchy/bvh_build.c']
IN_TESTS['film'] = ['src/photons/film.c']
IN_TESTS['share'] = [f'src/{name}.c' for name in [
    'photons/film', 'scene/rt_options', 'scene/resolved', 'photons/partial_film',
    'support/text_fields', 'support/atomic_file']]
SHARE = '7'  # every seventh member of the small world and of a regime
SECONDS = 120
PROCESSES = 2


class Build:
    """Compiles what a changed source reaches."""

    def __init__(self, options):
        self.root = options.root.resolve()
        self.scratch = options.scratch.resolve()
        self.judge = options.judge.resolve()
        self.cxx = options.cxx
        tiers, once = ([self.relative(path) for path in paths]
                       for paths in (options.tiers, options.once))
        self.variants = {'': tiers + once, '-DSURE_FLOAT32': tiers, '-DSURE_STABLE': tiers}
        self.command = options.compiler + ['-std=c11', '-O1', '-fPIC', '-w',
                                           f'-I{self.root}/include']
        self.reached = {source: self.includes(source)
                        for source in sorted(set(sum(self.variants.values(), [])))}
        self.unchanged = {}
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

    def copy(self, name, source, text):
        """A folder with the sources, `source` with this text."""
        folder = self.scratch / name
        shutil.copytree(self.root / 'src', folder / 'src')
        if source:
            (folder / source).write_text(text)
        return folder

    def run(self, command, folder):
        run = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        if run.returncode != 0:
            errors = re.findall(r'^.*error.*$', run.stderr, re.MULTILINE) or [run.stderr]
            raise Broken('does not compile: ' + errors[0].strip())

    def objects(self, folder, variant, sources):
        """{(variant, source): object} compiled from the sources as they are in the folder."""
        place = folder / ('objects' + variant)
        place.mkdir()
        if sources:
            self.run(self.command + [variant] * bool(variant) +
                     ['-c', *(str(folder / source) for source in sources)], place)
        return {(variant, source): place / (Path(source).stem + '.o') for source in sources}

    def library(self, name, source, text):
        """The library in which `source` reads `text`; with None the one without any change, which
        has to be made first."""
        folder = self.copy(name, source, text)
        made = {}
        for variant, sources in self.variants.items():
            made |= self.objects(folder, variant, [file for file in sources if source is None or
                                                   source in self.reached[file]])
        if not made:
            raise Broken(f'{source} reaches no source of the library')
        if source is None:
            self.unchanged = made
        library = folder / 'library.so'
        objects = [str(path) for path in (self.unchanged | made).values()]
        self.run(self.command + ['-shared', *objects, '-o', str(library), '-lgmp', '-lm'], folder)
        return library

    def program(self, name, stem, source, text):
        """The stem's test, compiled with what `source` then reads; all else that it needs is as it
        was."""
        folder = self.copy(name, source, text)
        shutil.copytree(self.root / 'tests' / 'support', folder / 'tests' / 'support')
        test = next((self.root / 'tests').glob(f'*/test_{stem}.c')).relative_to(self.root)
        (folder / test).parent.mkdir()
        shutil.copy(self.root / test, folder / test)
        made = folder / f'test_{stem}'
        self.run(self.command + [f'-DSUREHIT_TESTS="{self.root}/tests"', str(test),
                                 'tests/support/suite.c', *IN_TESTS[stem], '-o', str(made),
                                 str(self.judge), str(self.scratch / 'unchanged' / 'library.so'),
                                 *self.wanted_by_tests(), '-lm'], folder)
        return made

    @staticmethod
    def wanted_by_tests():
        return subprocess.run(['pkg-config', '--libs', 'check', 'mpfr', 'gmp'], check=True,
                              capture_output=True, text=True).stdout.split()


def parts_that_fail(program, stem, library):
    """The test cases of the stem's test that fail an assertion; empty when all pass. The library is
    None for a test that has none in its place."""
    for part in PARTS.get(stem, [None]):
        environment = dict(os.environ, CK_FORK='no', SUREHIT_SHARE=SHARE)
        if library:
            environment['LD_PRELOAD'] = str(library)
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


def judge(mutant, build, programs, sources):
    """The test cases that catch the mutant."""
    source, text = sources.apply(mutant)
    try:
        if mutant.stem in of_proofs.STEMS:
            folder = of_proofs.copy(build, mutant.name, source, text)
            caught = of_proofs.faults(build, mutant.stem, folder, mutant.place)
        elif mutant.stem in IN_TESTS:
            program = build.program(mutant.name, mutant.stem, source, text)
            caught = parts_that_fail(program, mutant.stem, None)
        else:
            library = build.library(mutant.name, source, text)
            caught = parts_that_fail(programs[f'test_{mutant.stem}'], mutant.stem, library)
    finally:
        shutil.rmtree(build.scratch / mutant.name, ignore_errors=True)
    if not caught:
        raise Broken('SURVIVES')
    return caught


def judge_unchanged(stem, build, library, programs):
    """The way of judging is sound only if it finds nothing where nothing is wrong."""
    if stem in of_proofs.STEMS:
        folder = of_proofs.copy(build, f'unchanged {stem}', None, None)
        failed = of_proofs.faults(build, stem, folder, None)
    elif stem in IN_TESTS:
        program = build.program(f'unchanged {stem}', stem, None, None)
        failed = parts_that_fail(program, stem, None)
    else:
        failed = parts_that_fail(programs[f'test_{stem}'], stem, library)
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
            elif erratum not in by_name[name].notes:
                yield f'{erratum}: {name} is not marked as this erratum'
    ids = {erratum for erratum, _ in rows}
    for mutant in mutants:
        yield from (f'{mutant.name}: no erratum {e}' for e in mutant.notes if e not in ids)
    if not rows:
        yield f'{errata}: no table of errata'


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--root', type=Path, required=True, help='the project')
    parser.add_argument('--scratch', type=Path, required=True, help='a folder to build in')
    parser.add_argument('--programs', type=Path, required=True, help='where the tests are built')
    parser.add_argument('--tiers', type=Path, nargs='+', required=True,
                        help='sources compiled once a plain tier')
    parser.add_argument('--once', type=Path, nargs='+', required=True, help='the other sources')
    parser.add_argument('--judge', type=Path, required=True, help='the library of the regimes')
    parser.add_argument('--cxx', nargs='+', help='a C++ compiler and its flags')
    parser.add_argument('--only', nargs='+', help='mutants or stems')
    parser.add_argument('compiler', nargs='+', help='after --: the compiler and its flags')
    options = parser.parse_args()

    folder = options.root / 'tests' / 'mutants'
    mutants, complaints = read(folder)
    if not options.cxx:
        mutants = [mutant for mutant in mutants if mutant.stem not in of_proofs.STEMS]
    if options.only:
        mutants = [mutant for mutant in mutants if {mutant.name, mutant.stem} & {*options.only}]
    if not options.only:
        complaints += errata_differences(options.root / 'docs' / 'errata.md', mutants)
    sources, build = Sources(options.root), Build(options)
    programs = {path.name: path for path in options.programs.rglob('test_*')}
    try:
        unchanged = build.library('unchanged', None, None)
    except Broken as error:
        sys.exit(f'the sources as they are: {error}')
    with concurrent.futures.ThreadPoolExecutor(PROCESSES) as pool:
        jobs = [(f'({stem} unchanged)',
                 pool.submit(judge_unchanged, stem, build, unchanged, programs))
                for stem in sorted({mutant.stem for mutant in mutants})]
        jobs += [(mutant.name, pool.submit(judge, mutant, build, programs, sources))
                 for mutant in mutants]
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
