# SPDX-License-Identifier: MIT
"""The names that C sources have for themselves, outside of their functions: not the linker's."""
import functools
import pathlib
import re
import subprocess

TOKEN = re.compile(r'[A-Za-z_]\w*|"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'|[0-9.][\w.]*|\S')
MARKER = re.compile(r'# \d+ "(.*)"((?: \d)*)$')
OPEN, CLOSE = "([{", ")]}"
BESIDE = ("__attribute__", "__asm__", "_Alignas", "_Static_assert")  # and what is in their brackets
TAGS = ("struct", "union", "enum")


class Group:
    """What stands in brackets."""

    def __init__(self, bracket):
        self.bracket, self.tokens = bracket, []


def is_group(token, bracket):
    return isinstance(token, Group) and token.bracket == bracket


def is_name(token):
    return isinstance(token, str) and re.match(r"[A-Za-z_]", token) is not None


def tokens_of(text):
    """(the files that a token stands in, the token) of what a preprocessor writes."""
    files = []
    for line in text.splitlines():
        marker = MARKER.match(line)
        if marker:
            left = {" 1": 0, " 2": 2}.get(marker[2][:2], 1)
            files = [*files[:len(files) - left], marker[1]]
        elif not line.startswith("#"):
            for token in TOKEN.findall(line):
                yield files, token


def declarations_of(text):
    """(files, tokens and groups) of each."""
    groups = [Group("")]
    for files, token in tokens_of(text):
        if token in OPEN:
            groups.append(Group(token))
            continue
        if token in CLOSE:
            token = groups.pop()
        groups[-1].tokens.append(token)
        if len(groups) == 1 and (token == ";" or is_function(groups[0].tokens)):
            yield files, groups.pop().tokens
            groups = [Group("")]


def is_function(tokens):
    """With its body, at whose end stands no semicolon."""
    return (is_group(tokens[-1], "{") and "=" not in tokens
            and not any(token in TAGS for token in tokens[-3:-1]))


def without_beside(tokens):
    return [token for before, token in zip([None, *tokens], tokens)
            if token not in BESIDE and before not in BESIDE]


def split(tokens):
    parts = [[]]
    for token in tokens:
        if token == ",":
            parts.append([])
        else:
            parts[-1].append(token)
    return parts


def tags_and_constants(tokens):
    """Of what is defined."""
    for i, token in enumerate(tokens):
        kind = next((tag for tag in tokens[max(0, i - 2):i] if tag in TAGS), None)
        if kind and is_group(token, "{"):
            if tokens[i - 1] != kind:
                yield tokens[i - 1]
            if kind == "enum":
                yield from (part[0] for part in split(token.tokens) if part)


def declared_name(tokens):
    """Of `type name`, `type name[n]`, `type name(...)` or `type (*name)(...)`."""
    for before, token in zip([None, *tokens], tokens):
        if is_group(token, "("):
            return next(filter(is_name, token.tokens)) if token.tokens[:1] == ["*"] else before
    return next(filter(is_name, reversed(tokens)), None)


def behind_type(tokens):
    """What is declared: a struct or an enum that is defined before it is left out."""
    for i, token in enumerate(tokens):
        if token == "=":
            break
        if is_group(token, "{") and any(tag in TAGS for tag in tokens[max(0, i - 2):i]):
            return tokens[i + 1:]
    return [] if tokens[0] in TAGS and len(tokens) == 2 else tokens


def names_of(tokens):
    tokens = [token for token in without_beside(tokens) if token != ";"]
    if not tokens:
        return
    yield from tags_and_constants(tokens)
    for part in split(behind_type(tokens)) if {"static", "typedef"}.intersection(
            filter(is_name, tokens)) else []:
        name = declared_name(part[:part.index("=")] if "=" in part else part)
        if name:
            yield name


def names(command, owners):
    """(owner, name) of what `command`, a preprocessor, writes. Owners are by the paths of their
    files; one that is None leaves it to who includes it."""
    text = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
    resolved = functools.cache(lambda name: pathlib.Path(name).resolve())
    for files, tokens in declarations_of(text):
        within = [resolved(name) for name in files]
        while within and owners.get(within[-1], "") is None:
            within.pop()
        if within and within[-1] in owners:
            for name in names_of(tokens):
                yield owners[within[-1]], name
