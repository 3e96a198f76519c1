#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""docs/fuzzing.md's figures out of record.json, those of the last runs with --record.

Without an argument they are written; with --check they are compared, and nothing is written."""
import json
import os
import sys
from pathlib import Path

import engines
import pages

FOLDER = Path(__file__).resolve().parent
PAGE = FOLDER.parent / 'docs' / 'fuzzing.md'
RECORD = FOLDER / 'record.json'
ENGINES = {'libfuzzer': 'libFuzzer', 'afl': 'AFL++'}
BUILDS = {'': '-O2', 'address,undefined': 'ASan, UBSan', 'memory': 'MSan, no reference'}


def read():
    record = json.loads(RECORD.read_text()) if RECORD.exists() else {}
    return {'runs': {}, 'seeded': {}, 'coverage': {}} | record


def save(record):
    """At once, so that an interruption leaves the old one or the new one."""
    made = RECORD.with_suffix('.new')
    made.write_text(json.dumps(record, indent=1, sort_keys=True) + '\n')
    os.replace(made, RECORD)


def run_name(target, engine, sanitizers):
    return ' '.join([target, engine, sanitizers]).strip()


def run_of(record, name, sources):
    """What there is already of these sources, without a find."""
    row = record['runs'].get(name, {})
    fits = row.get('sources') == sources and row['finds'] == 0
    return row if fits else {'executions': 0, 'compared': 0, 'seconds': 0, 'edges': 0}


def compared_so_far(target, engine, sanitizers, sources):
    return run_of(read(), run_name(target, engine, sanitizers), sources)['compared']


def has_run(target, engine, sanitizers, sources, piece):
    """Was the piece with that digest added?"""
    return piece in run_of(read(), run_name(target, engine, sanitizers), sources).get('pieces', [])


def add_run(target, engine, sanitizers, sources, result, piece=None):
    """Adds to the row of the same sources, or begins it; with the digest of another machine's."""
    record, name = read(), run_name(target, engine, sanitizers)
    old = run_of(record, name, sources)
    pieces = old.get('pieces', []) + [piece] * (piece is not None)
    record['runs'][name] = {
        'target': target, 'engine': engine, 'sanitizers': sanitizers, 'sources': sources,
        'executions': old['executions'] + result.executions,
        'compared': old['compared'] + result.compared,
        'seconds': round(old['seconds'] + result.seconds, 1),
        'edges': max(old['edges'], result.edges), 'finds': len(result.finds)}
    if pieces:
        record['runs'][name]['pieces'] = pieces
    save(record)


def add_seeded(mutant, seconds, law):
    record = read()
    record['seeded'][mutant.name] = {'target': mutant.stem, 'source': mutant.source,
                                     'why': mutant.why, 'seconds': round(seconds, 2), 'law': law}
    save(record)


def drop_seeded(names):
    """Those that there are no more."""
    record = read()
    record['seeded'] = {name: row for name, row in record['seeded'].items() if name in names}
    save(record)


def set_coverage(coverage):
    save(read() | {'coverage': coverage})


def escaped(text):
    return text.replace('|', '\\|').replace('*', '\\*')


def runs(record):
    head = ['target', 'engine', 'build', 'executions', 'compared', 'a second of a core', 'edges',
            'corpus', 'bytes', 'finds']
    rows = []
    for row in sorted(record['runs'].values(),
                      key=lambda row: engines.TARGETS.index(row['target'])):
        files, size = engines.corpus_size(row['target'])
        rate = row['compared'] / max(1, row['seconds'])
        rows.append([f'`{row["target"]}`', ENGINES[row['engine']], BUILDS[row['sanitizers']],
                     f'{row["executions"]:,}', f'{row["compared"]:,}', f'{rate:,.0f}',
                     row['edges'] or '', files, f'{size:,}', row['finds']])
    return pages.table(head, rows, range(3, len(head)))


def seeded(record):
    head = ['bug', 'in', 'what it is', 'seconds', 'found by']
    rows = [[f'`{name}`', f'`{row["source"]}`', escaped(row['why']), f'{row["seconds"]:.2f}',
             escaped(row['law'])] for name, row in record['seeded'].items()]
    return pages.table(head, rows, [3])


def coverage(record):
    head = ['room', 'lines', 'not reached', 'branches', 'not taken']
    rows = [[f'`{name}`', row['lines'], row['lines_left'], row['branches'], row['branches_left']]
            for name, row in record['coverage'].get('rooms', {}).items()]
    return pages.table(head, rows)


def unreached(record):
    return ''.join(f'- `{path}`: `{text}` ({many}): {why or "not explained"}\n'
                   for path, many, text, why in record['coverage'].get('left', [])) or 'None.\n'


def write(checked=False):
    """The exit status."""
    parts = {'runs': runs, 'seeded': seeded, 'coverage': coverage, 'unreached': unreached}
    values = {name: pages.block(make(read())) for name, make in parts.items()}
    return pages.written_or_checked(PAGE, values, 'fuzz/record.json', checked)


if __name__ == '__main__':
    sys.exit(write(sys.argv[1:] == ['--check']))
