# SPDX-License-Identifier: MIT
"""Builds the fuzz targets with an engine, and runs them."""
import fcntl
import hashlib
import os
import re
import shutil
import signal
import struct
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / 'tests' / 'support'))
from shapes import SHAPES  # noqa: E402

TARGETS = SHAPES + ['hit_order', 'spawn', 'parts', 'shading', 'quadratic', 'rotation', 'camera',
                    'photons', 'rt_reader', 'case', 'picture']
TEXTS = {'rt_reader': 1000, 'case': 1000}  # their longest inputs; of numbers:
LONGEST = 256
# What a target is about. Of a shape: but for what is asked of a hit, and the other shapes' folders.
NUMBERS = ['src/numbers', 'src/geometry']
PLACING = ['src/scene/placement']
ROOMS = dict.fromkeys(TARGETS, NUMBERS + ['src/shapes', 'src/stages']) | {
    'quadratic': NUMBERS, 'rotation': NUMBERS, 'shading': NUMBERS + ['src/shading'],
    'camera': NUMBERS + PLACING + ['src/tracer/camera', 'src/tracer/pixel_ray'],
    'photons': NUMBERS + ['src/shading', 'src/photons/forward', 'src/photons/mixed',
                          'src/tracer/backward', 'src/tracer/meeting', 'src/tracer/shadow'],
    'rt_reader': NUMBERS + PLACING + ['src/scene/rt'],
    'picture': ['src/image/picture', 'src/support/atomic_file'], 'case': ['src/cases/case']}
OTHERS = {shape: ('src/stages/hits/', *(f'src/shapes/{other}/' for other in SHAPES
                                        if other != shape))
          for shape in SHAPES}
MEMORY_AND_NUMBERS = 'address,undefined'
SANITIZERS = {'': [], MEMORY_AND_NUMBERS: ['-fno-sanitize-recover=all',
                                            '-fsanitize=float-cast-overflow'],
              'memory': ['-fno-sanitize-recover=all', '-fsanitize-memory-track-origins']}
MOST_FILES, MOST_BYTES = 400, 100_000  # of a committed corpus
BY_HAND = re.compile(r'.*[^0-9a-f].*|.{1,15}')  # an input that has a name; others are hashes
INTERRUPTED = 72  # libFuzzer's status


def environment(**more):
    """Debian's own tools go before whatever else PATH holds, as in .ci/common.sh."""
    return dict(os.environ, PATH='/usr/sbin:/usr/bin:/sbin:/bin:' + os.environ['PATH'], **more)


def quietly(command, **options):
    run = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, text=True, errors='replace', **options)
    if run.returncode != 0:
        sys.exit(f'{run.stdout}\nfailed: {" ".join(map(str, command))}')
    return run.stdout


class Build:
    """A build folder for an engine and a set of sanitizers, of this tree or of another."""

    def __init__(self, engine, sanitizers='', tree=ROOT, folder=None, piece=0):
        self.engine, self.sanitizers, self.tree, self.piece = engine, sanitizers, tree, piece
        name = '-'.join(['fuzz', engine, *sanitizers.replace(',', ' ').split()])
        self.folder = folder or ROOT / 'build' / name
        self.environment = environment(CC='clang', CXX='clang++')
        if engine == 'afl':
            self.environment |= {'CC': 'afl-clang-fast', 'CXX': 'afl-clang-fast++'}

    def configure(self):
        if (self.folder / 'build.ninja').exists():
            return
        flags = ' '.join(SANITIZERS[self.sanitizers])
        quietly(['meson', 'setup', self.folder, self.tree, '-Dbuildtype=debugoptimized',
                 '-Ddefault_library=static', '-Db_lundef=false', '-Dopenmp=disabled',
                 f'-Dfuzz={self.engine}', f'-Db_sanitize={self.sanitizers or "none"}',
                 f'-Dfuzz_reference={str(self.sanitizers != "memory").lower()}',
                 f'-Dc_args={flags}', f'-Dcpp_args={flags}',
                 f'-Dc_link_args={flags}', f'-Dcpp_link_args={flags}'], env=self.environment)

    def make(self, targets):
        """One after the other, where several pieces begin at once."""
        self.folder.parent.mkdir(exist_ok=True)
        with open(self.folder.with_suffix('.lock'), 'w') as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            self.configure()
            files = [f'fuzz/fuzz_{target}' for target in targets]
            quietly(['ninja', '-C', self.folder, *files], env=self.environment)

    def place(self, room, target):
        """Its folder of a target; a piece has its own."""
        return self.folder / room / (f'{target}.{self.piece}' if self.piece else target)

    def corpus(self, target):
        """The folder that engines read and add to."""
        folder = self.place('corpus', target)
        folder.mkdir(parents=True, exist_ok=True)
        return folder

    def program(self, target):
        return self.folder / 'fuzz' / f'fuzz_{target}'


def longest(target):
    return TEXTS.get(target, LONGEST)


def libfuzzer_options(target, seconds):
    """Entropic scheduling counts every feature of every execution, which takes longer than the
    executions."""
    return ['-entropic=0', '-len_control=0', f'-max_len={longest(target)}', '-timeout=60',
            f'-max_total_time={seconds}', '-print_final_stats=1', '-verbosity=1']


def code_of(file):
    code = re.sub(r'/\*.*?\*/', '', file.read_text(), flags=re.DOTALL)
    return ''.join(code.split())


def sources_of(target):
    """A digest of what the target is about, without comments and blanks: its rooms, and of the
    published bounds those that are used there."""
    about = ''
    for file in sorted((ROOT / 'src').rglob('*.[ch]')):
        name = file.relative_to(ROOT).as_posix()
        if name.startswith(tuple(ROOMS[target])) and not name.startswith(OTHERS.get(target, ())):
            about += name + code_of(file)
    bounds = (ROOT / 'include/surehit/bounds.h').read_text()
    for name, value in re.findall(r'^#define (SURE_\w+) (.+)$', bounds, re.MULTILINE):
        about += value if name in about else ''
    return hashlib.sha256(about.encode()).hexdigest()[:16]


def new_folder(path):
    shutil.rmtree(path, ignore_errors=True)
    path.mkdir(parents=True)
    return path


def new_counts(work):
    """The file of fuzz/counts.h."""
    (work / 'counts').write_bytes(bytes(16))
    return work / 'counts'


class Result:
    """What became of a target."""

    def __init__(self, target):
        self.target = target
        self.executions = self.compared = self.edges = 0
        self.seconds = 0.0  # of processor time
        self.finds, self.interrupted = [], False

    def __iadd__(self, other):
        self.executions += other.executions
        self.compared += other.compared
        self.seconds += other.seconds
        self.edges = max(self.edges, other.edges)
        self.finds += other.finds
        self.interrupted |= other.interrupted
        return self


class Processes:
    """Those of one run. An interruption ends them, and is no find; what they did counts."""

    def __init__(self):
        self.running, self.seconds, self.interrupted = [], 0.0, False

    def start(self, command, log, **options):
        with open(log, 'w') as file:
            self.running.append(subprocess.Popen([str(part) for part in command], stdout=file,
                                                 stderr=file, **options))

    def wait(self):
        for process in self.running:
            while process.returncode is None:
                try:
                    self.wait_for(process)
                except KeyboardInterrupt:
                    self.end()

    def wait_for(self, process):
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.seconds += usage.ru_utime + usage.ru_stime

    def end(self):
        self.interrupted = True
        for process in self.running:
            if process.returncode is None:
                process.terminate()

    def failed(self, process):
        gone = [0, INTERRUPTED, -signal.SIGTERM, -signal.SIGINT] if self.interrupted else [0]
        return process.returncode not in gone


def find_in(log, code):
    """The lines of fuzz_find, or the sanitizer's complaint."""
    lines = log.splitlines()
    for i, line in enumerate(lines):
        if line.startswith('find: '):
            return '\n'.join(lines[i:i + 3])
    told = re.search(r'^SUMMARY: (\w+Sanitizer: \S+)', log, re.MULTILINE)
    return told.group(1) if told else f'ended with status {code}'


def result_of(target, processes, counts):
    result = Result(target)
    result.executions, result.compared = struct.unpack('=2Q', counts.read_bytes())
    result.seconds, result.interrupted = processes.seconds, processes.interrupted
    return result


def run_libfuzzer(build, target, seconds, cores, corpus):
    """`cores` processes that share a corpus. Pieces that begin at the same time differ."""
    work = new_folder(build.place('work', target))
    counts, finds = new_counts(work), build.folder / 'finds'
    finds.mkdir(exist_ok=True)
    first, processes = int(time.time()) + build.piece * 999_983, Processes()
    for i in range(cores):
        processes.start([build.program(target), corpus, *libfuzzer_options(target, seconds),
                         f'-seed={(first * cores + i) % 2**32}', '-reload=10',
                         f'-artifact_prefix={finds}/{target}-'], work / f'log{i}',
                        env=environment(FUZZ_COUNTS=str(counts)))
    processes.wait()
    result = result_of(target, processes, counts)
    for i, process in enumerate(processes.running):
        text = (work / f'log{i}').read_text(errors='replace')
        edges = re.findall(r' cov: (\d+) ', text)
        result.edges = max(result.edges, int(edges[-1]) if edges else 0)
        if processes.failed(process):
            result.finds.append(f'{find_in(text, process.returncode)}\n(in {finds})')
    return result


def run_afl(build, target, seconds, cores, corpus):
    work = new_folder(build.place('work', target))
    counts = new_counts(work)
    setting = environment(FUZZ_COUNTS=str(counts), AFL_NO_UI='1', AFL_SKIP_CPUFREQ='1',
                          AFL_NO_AFFINITY='1', AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES='1')
    processes = Processes()
    for i in range(cores):
        role = ['-M', 'core0'] if i == 0 else ['-S', f'core{i}']
        processes.start(['afl-fuzz', '-i', corpus, '-o', work / 'out', *role, '-V', seconds,
                         '-G', longest(target), '--', build.program(target)], work / f'log{i}',
                        env=setting)
    processes.wait()
    result = result_of(target, processes, counts)
    for i, process in enumerate(processes.running):
        if processes.failed(process):
            result.finds.append((work / f'log{i}').read_text(errors='replace')[-1000:])
    for crash in sorted(work.glob('out/*/crashes/id*')) + sorted(work.glob('out/*/hangs/id*')):
        result.finds.append(str(crash))
    for kept in work.glob('out/*/queue/id*'):
        shutil.copy(kept, corpus / kept.name.replace(':', '_').replace(',', '_'))
    return result


def corpus_file(target):
    """The committed corpus: an input a line, its name and its bytes in hexadecimal."""
    return ROOT / 'fuzz' / 'corpus' / f'{target}.hex'


def committed(target):
    """{name: bytes}"""
    file = corpus_file(target)
    lines = file.read_text().splitlines() if file.exists() else []
    return {name: bytes.fromhex(data) for name, _, data in (line.partition(' ') for line in lines)}


def corpus_size(target):
    """Inputs and bytes of the committed one."""
    sizes = [len(data) for data in committed(target).values()]
    return len(sizes), sum(sizes)


def seed_corpus(build, target):
    """The build's, with what is committed, or one byte."""
    corpus = build.corpus(target)
    for name, data in committed(target).items():
        (corpus / name).write_bytes(data)
    if not any(corpus.iterdir()):
        (corpus / 'one').write_bytes(b'\2')
    return corpus


def minimise(build, target, corpus):
    """The fewest and smallest inputs that reach every edge, into fuzz/corpus/, beside those that
    have a name. Needs libFuzzer."""
    merged = new_folder(build.folder / 'merged' / target)
    quietly([build.program(target), '-set_cover_merge=1', '-use_counters=0', '-timeout=60',
             f'-max_len={longest(target)}', merged, corpus])
    inputs = {name: data for name, data in committed(target).items() if BY_HAND.fullmatch(name)}
    kept = sorted(merged.iterdir(), key=lambda path: (path.stat().st_size, path.name))
    files = size = 0
    for path in kept:
        files += 1
        size += path.stat().st_size
        if files > MOST_FILES or size > MOST_BYTES:
            break
        inputs[path.name[:16]] = path.read_bytes()
    corpus_file(target).write_text(''.join(f'{name} {inputs[name].hex()}\n'
                                           for name in sorted(inputs)))
