# SPDX-License-Identifier: MIT
"""Lines and branches of the library that tests and corpora together leave out, by gcc's count.

Files are compiled in several variants (numbers, tiers) and headers into several files: a branch
counts as taken when any of these takes it. What can't be taken stands in fuzz/unreachable, one a
line: file | how many lines and branches | the line's text | why."""
import gzip
import json
import re
import subprocess
from collections import defaultdict
from pathlib import Path

import engines
import page

ROOMS = ['src/numbers', 'src/geometry', 'src/shapes', 'src/stages']
SUITES = ['fast', 'hard', 'laws', 'exhaustive', 'fuzz']
# These compile the library anew, limit the size of files (counts would be cut off), or load the
# shared library.
ELSEWHERE = ['builds', 'command line', 'errata']
EACH = '-fprofile-update=atomic'  # threads lose counts else, and others are inferred from these
VARIANT = re.compile(r'_(f64|dd|ddb|mod128|exact|float32|textbook|stable|certain)$')


def tests_of(folder, setting):
    """Those whose programs are linked with the objects that are counted."""
    listed = json.loads(subprocess.run(['meson', 'introspect', '--tests', str(folder)], env=setting,
                                       stdout=subprocess.PIPE, text=True, check=True).stdout)
    suites = {f'surehit:{suite}' for suite in SUITES}
    return [test['name'] for test in listed
            if suites & set(test['suite']) and test['name'] not in ELSEWHERE]


def build_and_test(folder, cores):
    setting = engines.environment(CC='gcc', CXX='g++')
    if not (folder / 'build.ninja').exists():
        engines.quietly(['meson', 'setup', folder, engines.ROOT, '-Dbuildtype=debug',
                         '-Db_coverage=true', '-Ddefault_library=static', f'-Dc_args={EACH}'],
                        env=setting)
    engines.quietly(['ninja', '-C', folder, '-j', cores], env=setting)
    for count in folder.rglob('*.gcda'):
        count.unlink()
    run = subprocess.run(['meson', 'test', '-C', folder, '--no-rebuild', '-t', '10',
                          '--num-processes', str(cores), *tests_of(folder, setting)],
                         env=setting, stdout=subprocess.PIPE, text=True, errors='replace')
    if run.returncode != 0:
        print(run.stdout)
    return run.returncode


def reports(folder):
    """gcov's report of each object that ran."""
    for count in sorted(folder.rglob('*.gcda')):
        made = subprocess.run(['gcov', '--json-format', '--branch-probabilities', '--stdout',
                               str(count)], cwd=folder, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, check=True).stdout
        for line in made.splitlines():
            if line.strip():
                yield json.loads(gzip.decompress(line) if line[:2] == b'\x1f\x8b' else line)


def room_of(path):
    """The room that the file is in, if it is one of these."""
    return next((room for room in ROOMS if path.startswith(room + '/')), None)


def in_tree(name, folder):
    """The file as the tree has it."""
    path = Path(folder, name).resolve()
    return path.relative_to(engines.ROOT).as_posix() if path.is_relative_to(engines.ROOT) else ''


def count(folder):
    """{(file, line): times}, {(file, line, function, branches of it, which): times}"""
    lines, branches = defaultdict(int), defaultdict(int)
    for report in reports(folder):
        for file in report['files']:
            path = in_tree(file['file'], folder)
            for line in file['lines'] if room_of(path) else []:
                number = line['line_number']
                function = VARIANT.sub('', line.get('function_name', ''))
                lines[path, number] += line['count']
                # Without a name it was inlined by a test that asks for -O3.
                for which, branch in enumerate(line['branches'] if function else []):
                    key = path, number, function, len(line['branches']), which
                    branches[key] += branch['count']
    return lines, branches


def reasons():
    """{(file, text): (how many, why)}"""
    rows = {}
    for line in (engines.ROOT / 'fuzz' / 'unreachable').read_text().splitlines():
        file, many, rest = line.split(' | ', 2)
        text, why = rest.rsplit(' | ', 1)
        rows[file, text] = int(many), why
    return rows


def not_taken(counts):
    """{file: {line number: how many of it}}"""
    left = defaultdict(lambda: defaultdict(int))
    for key, times in counts.items():
        if times == 0:
            left[key[0]][key[1]] += 1
    return left


def summed(lines, branches):
    """{room: its figures}"""
    rooms = {room: dict.fromkeys(['lines', 'lines_left', 'branches', 'branches_left'], 0)
             for room in ROOMS}
    for kind, counts in (('lines', lines), ('branches', branches)):
        for key, times in counts.items():
            room = rooms[room_of(key[0])]
            room[kind] += 1
            room[kind + '_left'] += times == 0
    return rooms


def judged(lines, branches):
    """[[file, how many, text, why]], the last empty where it is not what fuzz/unreachable has."""
    by_text = defaultdict(int)
    for counts in (lines, branches):
        for path, numbers in not_taken(counts).items():
            texts = (engines.ROOT / path).read_text().splitlines()
            for number, many in numbers.items():
                by_text[path, texts[number - 1].strip()] += many
    known, rows = reasons(), []
    for (path, text), many in sorted(by_text.items()):
        expected, why = known.get((path, text), (0, ''))
        rows.append([path, many, text, why if many == expected else ''])
    return rows


def run(cores, record):
    folder = engines.ROOT / 'build' / 'fuzz-coverage'
    failed = build_and_test(folder, cores)
    lines, branches = count(folder)
    rooms, rows = summed(lines, branches), judged(lines, branches)
    for path, many, text, why in rows:
        print(f'{path}: {many} of {text}\n    {why or "NO REASON GIVEN"}')
    for name, room in rooms.items():
        print(name, room)
    if record:
        page.set_coverage({'rooms': rooms, 'left': rows})
    return failed or sum(why == '' for *_, why in rows)
