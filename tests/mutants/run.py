# SPDX-License-Identifier: MIT
"""Do the tests notice? Each entry of the *.mutants files beside this one (mutant.py says how they
read) is a deliberate bug in one function, and its stem's test, test_<stem>, has to fail on it.

To add a mutant, write an entry into its stem's file and run this with --only and its name. One
whose code moves to another file stays as it is; one whose function or text has a new name follows
it, and a run with --check tells within a second which entries no longer apply.

All mutants are built at once: a function becomes a switch between its bodies, a macro a choice
between its values, by a number from the environment. What this reaches is compiled anew by the
build's own commands, in a copy of the sources, and makes a library that is loaded before the real
one, so that the test programs run as they were built; what lies in a header alone, or in the
tracer, is part of its test, which is built anew too. A mutant is caught when its test fails an
assertion, its own or one of the library; another crash, a hang or a compiler's error is no catch.
caught.txt has which of its tests was the first to catch it: that one is asked first, and where it
finds nothing all are. It is made anew with --record.
"""

import argparse
import concurrent.futures
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import of_proofs
from mutant import Broken, Sources, read

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / 'support'))
from ending import end  # noqa: E402

IN_TESTS = {'limbs', 'dd', 'ddb', 'mod128', 'uint128', 'bvh', 'film', 'forward', 'share', 'adjoint',
            'coarse', 'expressions', 'discriminant', 'camera_rays', 'mixed', 'packet',
            'guess', 'wide', 'interaction', 'filter', 'close', 'query'}  # built anew
OF_TESTS = re.compile('libsurehit-(judge|support)')  # as they are: cases and truths
SHARE = '7'  # every seventh member of the small world and of a regime
SECONDS = 600  # of the processor
PROCESSES = 2
NUMBER = """
#ifdef __cplusplus
#include <cstdlib>
#else
extern char *getenv(const char *);
extern int atoi(const char *);
#endif
static int sure_mutant;
__attribute__((constructor)) static void sure_read_mutant(void)
{
    const char *number = getenv("SURE_MUTANT");
    sure_mutant = number ? atoi(number) : 0;
}
"""


def weave(sources, mutants, complaints):
    """{source: text} with all mutants in, each chosen by its number."""
    places = {}
    for number, mutant in enumerate(mutants, 1):
        mutant.number = number
        try:
            place, edits = sources.find(mutant)
            if mutant.stem != 'proofs':
                places.setdefault(place, []).append((mutant, sources.changed(place, edits)))
        except Broken as error:
            complaints.append(f'{mutant.name}: {error}')
    woven = {}
    for place in sorted(places, key=lambda place: -place.start):
        text = woven.get(place.source, sources.texts[place.source])
        if any(other is not place and other.source == place.source and
               other.start < place.end and place.start < other.end for other in places):
            complaints.append(f'{places[place][0][0].name}: one place within another')
        body = text[place.start:place.end]
        if place.is_macro:
            for mutant, changed in places[place]:
                body = f'(sure_mutant == {mutant.number} ? ({changed}) : ({body}))'
            body = ' ' + body
        else:
            cases = ''.join(f' case {mutant.number}: /* {mutant.name} */ {{{changed}}} break;'
                            for mutant, changed in places[place])
            body = f' switch (sure_mutant) {{{cases} default: {{{body}}} }} '
        woven[place.source] = text[:place.start] + body + text[place.end:]
    return woven


class Build:
    """A copy of the build folder beside a copy of the sources, where they lie to one another as
    they do in truth, so that the build's commands hold there; in an empty folder."""

    def __init__(self, root, folder, scratch):
        common = os.path.commonpath([root, folder])
        self.real_root, self.real_folder = root, folder
        self.root, self.folder = (scratch / path.relative_to(common) for path in (root, folder))
        self.number = scratch / 'number.h'

    def ask_ninja(self, *question):
        return subprocess.run(['ninja', '-t', *question], cwd=self.real_folder, check=True,
                              capture_output=True, text=True).stdout

    def copy(self, woven):
        for room in ('src', 'include', 'reference', 'tests'):
            shutil.copytree(self.real_root / room, self.root / room,
                            ignore=shutil.ignore_patterns('golden', 'vectors', 'scenes'))
        for source, text in woven.items():
            (self.root / source).write_text(text)
        self.number.write_text(NUMBER)

    def reached(self, woven):
        """The objects that a woven source is part of, but for those of the tests' own libraries."""
        changed = {os.path.relpath(self.real_root / source, self.real_folder) for source in woven}
        blocks = re.findall(r'^(\S+): #deps.*\n((?:    .*\n)*)', self.ask_ninja('deps'),
                            re.MULTILINE)
        return {name for name, deps in blocks
                if changed & set(deps.split()) and not OF_TESTS.search(name)}

    def run(self, command):
        run = subprocess.run(command, shell=True, cwd=self.folder, capture_output=True, text=True)
        if run.returncode != 0:
            sys.exit(f'the sources with all mutants in: {self.complaint(run.stderr)}')

    def complaint(self, said):
        """The first error, and the mutant near whose text it is."""
        where = re.search(r'^([^:\n]+):(\d+):\d+: error: .*', said, re.MULTILINE)
        if not where:
            return said or 'it has nothing to say'
        lines = (self.folder / where[1]).read_text().splitlines()[:int(where[2])]
        names = re.findall(r'case \d+: /\* (\S+) \*/', '\n'.join(lines))
        return f'{where[0]} (near {", ".join(names[-1:])})'

    def make(self, woven, targets):
        """Runs the commands that make the targets, but compiles only what is reached."""
        self.copy(woven)
        reached, links = self.reached(woven), []
        with concurrent.futures.ThreadPoolExecutor(PROCESSES) as pool:
            jobs = []
            for command in self.ask_ninja('commands', *targets).splitlines():
                made = re.search(r' (?:-o|csrDT|--capture) (\S+)', command)
                if made:
                    (self.folder / made[1]).parent.mkdir(parents=True, exist_ok=True)
                if '--internal exe' in command:
                    self.run(command)
                elif ' -c ' not in command:
                    links += [command] * ('--internal' not in command)
                elif made[1] in reached or not (self.real_folder / made[1]).is_file():
                    jobs.append(pool.submit(self.run, f'{command} -O1 -g0 -w '
                                                      f'-include {shlex.quote(str(self.number))}'))
                else:
                    (self.folder / made[1]).symlink_to(self.real_folder / made[1])
            for job in jobs:
                job.result()
        for command in links:
            self.run(command)


def first_failure(command, library, number, case=None):
    """The first assertion that fails, as its test's name and what it says; None when there is none
    in that test alone, or in any."""
    environment = dict(os.environ, CK_FORK='no', CK_TAP_LOG_FILE_NAME='-', SUREHIT_SHARE=SHARE,
                       LD_PRELOAD=str(library), SURE_MUTANT=str(number), OMP_WAIT_POLICY='passive')
    environment.pop('CK_RUN_CASE', None)
    environment |= {'CK_RUN_CASE': case} if case else {}
    with subprocess.Popen(['sh', '-c', f'ulimit -t {SECONDS}; exec "$@"', 'sh', *command],
                          cwd=library.parent, env=environment, text=True, errors='replace',
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as run:
        lines = []
        for line in run.stdout:
            lines.append(line.strip())
            failed = re.match(r'not ok \d+ - [^:]*:((\w+):.*)', line)
            if failed:
                run.kill()
                return failed[2], failed[1]
            if re.match(r'\S+:\d+:F:', line):
                run.kill()
                return None, line.split(':F:')[1].strip()
            if re.search(r': \w+: Assertion `.*\' failed', line):
                return None, line.split(': ', 1)[1]
    if run.returncode == 1 and lines[-1:] == ['0 passed, 1 failed']:
        return None, lines[0]
    if run.returncode != 0:
        raise Broken(f'{command[0]} ends with status {run.returncode}, not by an assertion')
    return None


def prove(mutant, sources, build):
    """The proofs that do not hold with the mutant's constant."""
    failed = of_proofs.judge(build.real_root, build.root / mutant.name, mutant,
                             *sources.apply(mutant))
    if not failed:
        raise Broken('SURVIVES')
    return None, ', '.join(failed)


def judge(mutant, command, library, test):
    """The assertion that catches the mutant; in the test that caught it before, or in any."""
    try:
        failure = test and first_failure(command, library, mutant.number, test)
    except Broken:  # there is no such test any more
        failure = None
    failure = failure or first_failure(command, library, mutant.number)
    if not failure:
        raise Broken('SURVIVES')
    return failure


def judge_unchanged(command, library, case):
    """The way of judging is sound only if it finds nothing where nothing is wrong, in a test that
    has caught a mutant."""
    failure = first_failure(command, library, 0, case)
    if failure:
        raise Broken(f'fails without any mutant: {failure[1]}')
    return None, 'nothing, rightly'


def outcomes(jobs, complaints, caught):
    """{stem: {test that failed, or None where it has no name}} of {name: (stem, job)}; and which
    caught whom."""
    tests = {}
    for name, (stem, job) in jobs.items():
        try:
            caught[name], words = job.result()
            tests.setdefault(stem, set()).add(caught[name])
        except Broken as error:
            words = str(error)
            complaints.append(f'{name}: {error}')
        print(f'{name:40} {words[:140]}', flush=True)
    return tests


def judge_all(mutants, commands, library, judge_proof, complaints, caught):
    """`caught`: {mutant: test that caught it before}, and now."""
    with concurrent.futures.ThreadPoolExecutor(PROCESSES) as pool:
        jobs = {mutant.name: (mutant.stem, pool.submit(judge_proof, mutant)
                              if mutant.stem == 'proofs' else
                              pool.submit(judge, mutant, commands[mutant.stem], library,
                                          caught.get(mutant.name)))
                for mutant in mutants}
        outcomes({f'({stem} {test or "all"} unchanged)': (stem, pool.submit(
                      judge_unchanged, commands[stem], library, test))
                  for stem, tests in outcomes(jobs, complaints, caught).items()
                  if stem in commands
                  for test in ([None] if None in tests else sorted(tests))}, complaints, {})


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


def programs_of(targets):
    """{stem: its test's path}; that of no stem has another name."""
    programs = {}
    for path, name in re.findall(r'^(\S*/(\w+)): (?:c|cpp)_LINKER', targets, re.MULTILINE):
        stem = name.removesuffix('_O3').removeprefix('test_')
        if programs.setdefault(stem, path) != path:
            sys.exit(f'{programs[stem]} and {path} are both the test of {stem}')
    return programs


def build_and_judge(options, sources, mutants, complaints, caught, scratch):
    build = Build(options.root, options.build, scratch)
    targets = build.ask_ninja('targets', 'all')
    library, = re.findall(r'^(\S*libsurehit\.so\S*): c_LINKER', targets, re.MULTILINE)
    programs = programs_of(targets)
    absent = {*of_proofs.PROGRAMS, 'proofs'} - of_proofs.available(programs)
    mutants = [mutant for mutant in mutants if mutant.stem not in absent]
    stems = sorted({mutant.stem for mutant in mutants} - {'proofs'})
    build.make(weave(sources, mutants, complaints),
               [library] + [programs[stem] for stem in stems if stem in IN_TESTS])
    commands = {}
    for stem in stems:
        program = (build.folder if stem in IN_TESTS else build.real_folder) / programs[stem]
        commands[stem] = (of_proofs.command(options.root, stem, program)
                          if stem in of_proofs.PROGRAMS else [program])
    judge_all(mutants, commands, build.folder / library,
              lambda mutant: prove(mutant, sources, build), complaints, caught)


def piece(words):
    """I/N of the mutants: every N-th one, from the I-th on."""
    parts = re.fullmatch(r'(\d+)/(\d+)', words)
    if not parts or not 1 <= int(parts[1]) <= int(parts[2]):
        raise argparse.ArgumentTypeError(f'{words}: expected I/N, I from 1 to N')
    return slice(int(parts[1]) - 1, None, int(parts[2]))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--root', type=Path, required=True, help='the project')
    parser.add_argument('--build', type=Path, default='.', help='where it is built')
    parser.add_argument('--only', nargs='+', help='mutants or stems')
    parser.add_argument('--piece', metavar='I/N', type=piece, default='1/1',
                        help='the I-th of N pieces, which many machines take one each')
    parser.add_argument('--check', action='store_true', help='only whether each applies')
    parser.add_argument('--record', action='store_true',
                        help='anew, which test is the first to catch whom: it is asked first then')
    options = parser.parse_args()
    options.root, options.build = options.root.resolve(), options.build.resolve()

    mutants, complaints = read(options.root / 'tests' / 'mutants')
    complaints += errata_differences(options.root / 'docs' / 'errata.md', mutants)
    sources = Sources(options.root)
    everyone = {mutant.name for mutant in mutants}
    if options.only:
        mutants = [mutant for mutant in mutants if {mutant.name, mutant.stem} & {*options.only}]
    mutants = mutants[options.piece]
    if options.check:
        seeded, more = read(options.root / 'fuzz' / 'seeded')
        complaints += more
        weave(sources, mutants + seeded, complaints)
    elif not complaints:
        record = options.root / 'tests' / 'mutants' / 'caught.txt'
        caught = dict(map(str.split, record.read_text().splitlines()))
        if options.record:
            anew = {mutant.name for mutant in mutants}
            caught = {name: caught[name] for name in everyone & {*caught} - anew}
        with tempfile.TemporaryDirectory(prefix='mutants.', dir=options.build) as scratch:
            build_and_judge(options, sources, mutants, complaints, caught, Path(scratch))
        if options.record and not complaints:
            record.write_text(''.join(f'{name} {test}\n' for name, test in sorted(caught.items())
                                      if test))
    print(f'{len(mutants)} mutants, {len(complaints)} complaints')
    for complaint in complaints:
        print(f'  {complaint}')
    return 1 if complaints or not mutants else 0


if __name__ == '__main__':
    end(main)
