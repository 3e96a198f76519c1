# SPDX-License-Identifier: MIT
"""Deliberate bugs, which the fuzzer has to find: fuzz/seeded/<target>.mutants, of the format of
tests/mutants/mutant.py; what stands in the brackets are the sanitizers that have to see the bug.
Each is applied to a copy of the tree and fuzzed from nothing, without the corpus, on one core."""
import concurrent.futures
import shutil
import sys
import threading

import engines
import page

sys.path.insert(0, str(engines.ROOT / 'tests' / 'mutants'))
from mutant import Broken, Sources, read  # noqa: E402

SECONDS = 60  # the bar
PATIENCE = 3  # so many times as long by the clock
SEED = 1
LOCK = threading.Lock()  # of the record
FOLDERS = ['src', 'include', 'reference', 'tests', 'fuzz', 'docs']


def copy_tree(tree):
    """Only what has changed, so that little is compiled anew."""
    tree.mkdir(parents=True, exist_ok=True)
    files = [path for path in engines.ROOT.iterdir() if path.is_file()]
    for folder in FOLDERS:
        files += [path for path in (engines.ROOT / folder).rglob('*') if path.is_file()]
    for path in files:
        if 'corpus' not in path.parts:
            refresh(path, tree / path.relative_to(engines.ROOT))


def refresh(path, copy):
    if not copy.is_file() or copy.read_bytes() != path.read_bytes():
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_bytes(path.read_bytes())


def make(mutant, sources, build, scratch):
    """The mutant's program, outside the build folder, where the next one is made."""
    mutant.source, wrong = sources.apply(mutant)
    source, right = build.tree / mutant.source, sources.texts[mutant.source]
    source.write_text(wrong)
    try:
        build.make([mutant.stem])
        return shutil.copy(build.program(mutant.stem), scratch / mutant.name)
    finally:
        source.write_text(right)


def time_to_find(mutant, program, scratch):
    """In processor time, so that it does not matter what else the machine does."""
    corpus = engines.new_folder(scratch / f'{mutant.name}.corpus')
    log = scratch / f'{mutant.name}.log'
    processes = engines.Processes()
    processes.start([program, corpus, f'-seed={SEED}',
                     *engines.libfuzzer_options(mutant.stem, PATIENCE * SECONDS),
                     f'-artifact_prefix={corpus}/'], log)
    processes.wait()
    code = processes.running[0].returncode
    if processes.interrupted:
        raise KeyboardInterrupt
    if code == 0 or processes.seconds > SECONDS:
        raise Broken(f'not found in {SECONDS} s')
    find = engines.find_in(log.read_text(errors='replace'), code)
    law = find.splitlines()[0].removeprefix(f'find: {mutant.stem}: ')
    if not mutant.notes and not find.startswith('find: '):
        raise Broken(f'no find, but: {find}')
    if mutant.notes and 'Sanitizer: ' not in law:
        raise Broken(f'no complaint of a sanitizer, but: {find}')
    return processes.seconds, law


def judge(mutant, program, scratch, record):
    """A complaint or None."""
    try:
        seconds, law = time_to_find(mutant, program, scratch)
    except Broken as error:
        print(f'{mutant.name:44} {error}', flush=True)
        return f'{mutant.name}: {error}'
    print(f'{mutant.name:44} {seconds:6.1f} s  {law}', flush=True)
    if record:
        with LOCK:
            page.add_seeded(mutant, seconds, law)
    return None


def folder_of(scratch, sanitizers):
    return scratch / '-'.join(['build', *sanitizers.split(',')]).rstrip('-')


def run(targets, cores, record):
    scratch = engines.ROOT / 'build' / 'fuzz-seeded'
    tree = scratch / 'tree'
    copy_tree(tree)
    builds = {name: engines.Build('libfuzzer', name, tree, folder_of(scratch, name))
              for name in engines.SANITIZERS}
    everyone, failures = read(engines.ROOT / 'fuzz' / 'seeded')
    mutants = [mutant for mutant in everyone if mutant.stem in targets]
    sources = Sources(engines.ROOT)
    missing = set(targets) - {mutant.stem for mutant in mutants}
    failures += [f'{target}: no seeded bug' for target in sorted(missing)]
    with concurrent.futures.ThreadPoolExecutor(cores) as pool:
        jobs = []
        for mutant in mutants:
            program = make(mutant, sources, builds[''.join(mutant.notes)], scratch)
            jobs.append(pool.submit(judge, mutant, program, scratch, record))
    failures += [complaint for complaint in (job.result() for job in jobs) if complaint]
    if record:
        page.drop_seeded({mutant.name for mutant in everyone})
    print(f'{len(mutants)} seeded bugs, {len(failures)} complaints')
    for failure in failures:
        print(f'  {failure}')
    return len(failures)
