# SPDX-License-Identifier: MIT
"""The mutants' format, and how a mutant finds its place. A file <stem>.mutants has entries like

    sphere-far-end-first: span_first_end in span.h (E14): the far end is taken first
    ~ t_min <= chord->[-enter-]{+leave+}

The place is a function or a macro of src or include, `in FILE` where several files have one of the
name; a name that a macro makes, as TIER(sure_sphere_normal), is given by what the macro is handed.
In the brackets, where there are any: the errata of docs/errata.md whose printed form it is.
A `~` line is a change as `git diff --word-diff` shows it: what goes between [- and -], what comes
between {+ and +}. One that takes several lines has `-` lines for what goes and `+` lines for what
comes, if anything does. The text before the change occurs exactly once in the place; white space
and comments do not count. An entry may have several changes.
"""

import re
from pathlib import Path

SPACE = r'\s|\\\n|/\*.*?\*/|//[^\n]*'
DIRECTIVE = r'^[ \t]*#(?:/\*.*?\*/|\\\n|[^\n])*'
TOKEN = re.compile(rf'(?P<space>{SPACE})|(?P<directive>{DIRECTIVE})|"(?:\\.|[^"\\])*"|'
                   r"'(?:\\.|[^'\\])*'|\.?\d(?:[eEpP][+-]|[\w.])*|\w+|"
                   r'<<=|>>=|\.\.\.|->|\+\+|--|<<|>>|&&|\|\||##|[<>=!+\-*/%&|^]=|.',
                   re.DOTALL | re.MULTILINE)
HEADER = re.compile(r'(\w+-[\w-]+): (\w+)(?: in (\S+))?(?: \(([^)]*)\))?: (.+)')

ADDED, REMOVED = re.compile(r'\{\+(.*?)\+\}'), re.compile(r'\[-(.*?)-\]')  # of a word diff


class Broken(Exception):
    """Why a mutant cannot be judged or is not caught."""


def tokens(text, start=0, end=None):
    """The matches of what is neither white space nor comment."""
    found = TOKEN.finditer(text, start, len(text) if end is None else end)
    return [token for token in found if not token['space']]


def words(text, start=0, end=None):
    return [token[0] for token in tokens(text, start, end)]


class Mutant:
    def __init__(self, stem, header):
        parts = HEADER.fullmatch(header)
        if not parts:
            raise Broken(f'no header: {header}')
        self.name, self.place, self.file, notes, self.why = parts.groups()
        self.stem, self.notes = stem, (notes or '').split()
        self.changes = []  # [old, new]
        if not self.name.startswith(stem + '-'):
            raise Broken(f'{self.name}: its name has to begin with its stem')

    def add(self, sign, text):
        if sign == '~':
            self.add('-', REMOVED.sub(r'\1', ADDED.sub(' ', text)))
            return self.add('+', ADDED.sub(r'\1', REMOVED.sub(' ', text)))
        if sign == '-' and (not self.changes or self.changes[-1][1]):
            self.changes.append(['', ''])
        self.changes[-1]['-+'.index(sign)] += text + '\n'

    def edits(self, text, start, end):
        """[(from, to, new)] in this part of the text."""
        here, made = tokens(text, start, end), []
        spelt = [token[0] for token in here]
        for old, new in self.changes:
            old = words(old)
            at = [i for i in range(len(spelt) - len(old) + 1) if spelt[i:i + len(old)] == old]
            if len(at) != 1 or old == words(new):
                raise Broken(f'{len(at)} times "{" ".join(old)}"' if len(at) != 1 else 'no change')
            made.append((here[at[0]].start(), here[at[0] + len(old) - 1].end(), new.strip()))
        return sorted(made)


def read(folder):
    """The mutants of a folder's files, and complaints."""
    mutants, complaints = [], []
    for path in sorted(folder.glob('*.mutants')):
        for number, line in enumerate(path.read_text().splitlines(), 1):
            try:
                if line[:1] in ('-', '+', '~'):
                    mutants[-1].add(line[0], line[2:])
                elif line.startswith(' '):
                    mutants[-1].why += ' ' + line.strip()
                elif line:
                    mutants.append(Mutant(path.stem, line))
            except (Broken, IndexError) as error:
                complaints.append(f'{path.name}:{number}: {error}')
    return mutants, complaints


class Place:
    """The body of a function, or what a macro stands for: text[start:end] of the source."""
    def __init__(self, source, name, start, end, is_macro):
        self.source, self.name, self.is_macro = source, name, is_macro
        self.start, self.end = start, end


def name_before(spelt, at):
    """The name of the function whose parameters end at this place of the list."""
    def opening(at):
        depth = 0
        while at >= 0:
            depth += {')': 1, '(': -1}.get(spelt[at], 0)
            if depth == 0:
                break
            at -= 1
        return at
    before = opening(at) - 1
    if before >= 0 and spelt[before] == ')':
        first = opening(before)
        return ''.join(word for word in spelt[first + 1:before] if re.fullmatch(r'\w+', word))
    return spelt[before] if before >= 0 else ''


def places_of(source, text, start=0, end=None):
    """Its functions and macros, functions in macros among them."""
    found, depth, body, here = [], 0, 0, tokens(text, start, end)
    spelt = [token[0] for token in here]
    for i, token in enumerate(here):
        if token['directive']:
            macro = re.match(r'\s*#\s*define\s+(\w+)(?:\([^)]*\))?', token[0])
            if macro and depth == 0:
                begin = token.start() + macro.end()
                found.append(Place(source, macro[1], begin, token.end(), True))
                found += places_of(source, text, begin, token.end())
        elif token[0] == '{':
            if depth == 0:
                body = i if i and spelt[i - 1] == ')' else None
            depth += not (i and spelt[i - 1].startswith('"'))  # extern "C"
        elif token[0] == '}' and depth:
            depth -= 1
            if depth == 0 and body:
                found.append(Place(source, name_before(spelt, body - 1),
                                   here[body].end(), token.start(), False))
    return found


class Sources:
    """What mutants may change: {source: text} and all places in it."""
    def __init__(self, root):
        files = [*root.glob('src/**/*'), *root.glob('include/**/*')]
        self.texts = {path.relative_to(root).as_posix(): path.read_text() for path in sorted(files)
                      if path.suffix in ('.c', '.h', '.inc', '.def')}
        self.places = [place for source, text in self.texts.items()
                       for place in places_of(source, text)]

    def find(self, mutant):
        """The place of a mutant, and its edits there."""
        named = [place for place in self.places if place.name == mutant.place
                 and mutant.file in (None, Path(place.source).name)]
        fitting, reasons = [], [f'{len(named)} places of the name']
        for place in named:
            text = self.texts[place.source]
            try:
                fitting.append((place, mutant.edits(text, place.start, place.end)))
            except Broken as error:
                reasons.append(str(error))
        if len(fitting) != 1:
            raise Broken(f'fits {len(fitting)} times {mutant.place}: {", ".join(reasons)}')
        return fitting[0]

    def changed(self, place, edits):
        """The text of the place with the edits made."""
        text, at, parts = self.texts[place.source], place.start, []
        for start, end, new in edits:
            parts += [text[at:start], new]
            at = end
        return ''.join(parts) + text[at:place.end]

    def apply(self, mutant):
        """The source that the mutant changes, and how it then reads."""
        place, edits = self.find(mutant)
        text = self.texts[place.source]
        return place.source, text[:place.start] + self.changed(place, edits) + text[place.end:]
