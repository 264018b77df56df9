"""Which commands the READMEs name: in blocks between ``` and in `spans`."""
import pathlib
import re
import shlex
import subprocess
from dataclasses import dataclass

FENCE = re.compile(r"^ *```", re.MULTILINE)
SPAN = re.compile(r"`([^`\n]+)`")
OWN_PATH = re.compile(r"(tests|deploy|\.ci)/[\w./-]*\w")
ASSIGNMENT = re.compile(r"[A-Z_]+=")
SEPARATORS = ("&&", "||", ";", "&", "|")
# Programs that are no file of the repository, and how many further words say what they do.
PROGRAMS = {"cmake": 1, "node": 1, "npm": 1, "cutaway": 1, "cutaway-load": 0}


@dataclass(frozen=True)
class Named:
    """command: as written. key: the program and what it is told to do, without options' values."""

    readme: str
    command: str
    key: str


def tracked(root, *patterns, executable=False):
    listing = subprocess.run(
        ["git", "ls-files", "--stage", "--", *patterns], cwd=root, capture_output=True, text=True, check=True
    )
    lines = (line.split("\t", 1) for line in listing.stdout.splitlines())
    return [path for facts, path in lines if not executable or facts.startswith("100755")]


def all_named(root):
    """[Named] of every README under version control."""
    scripts = set(tracked(root, executable=True))
    files = set(tracked(root))
    there = files | {str(folder) for file in files for folder in pathlib.PurePath(file).parents}
    found = []
    for readme in tracked(root, "*README.md"):
        text = (pathlib.Path(root) / readme).read_text()
        found += [Named(readme, command, key) for command, key in named_in(text, scripts, there)]
    return found


def named_in(text, scripts, there):
    """(command, key) of each; scripts: paths of what can be started; there: of all files and
    folders. The key of a path that is not there is the path."""
    for piece in _pieces(text):
        for command in _commands(piece):
            key = key_of(command, scripts, there)
            if key:
                yield " ".join(command), key


def key_of(words, scripts, there):
    """None where this is no command."""
    words = [word for word in words if not ASSIGNMENT.match(word)]
    if not words or words[0].startswith("-"):
        return None
    program = words[0].removeprefix("build/release/")
    if program in scripts or (OWN_PATH.fullmatch(program) and program not in there):
        return program
    by_name = [script for script in scripts if script.rsplit("/", 1)[-1] == program]
    if len(by_name) == 1 and len(words) > 1 and words[1].startswith("-"):
        return by_name[0]
    if program in PROGRAMS and len(words) > PROGRAMS[program]:
        return " ".join([program, *_said(program, words[1:])])
    return None


def _said(program, words):
    if program == "npm" and words[0] == "run":
        return words[:2]
    return words[: PROGRAMS[program]]


def _pieces(text):
    """Lines of blocks, joined where they are continued, and spans outside of blocks."""
    for number, part in enumerate(FENCE.split(text)):
        if number % 2 == 0:
            yield from SPAN.findall(part)
            continue
        lines = part.split("\n", 1)[-1].replace("\\\n", " ")
        yield from (line.split(" #", 1)[0] for line in lines.splitlines() if not line.startswith("#"))


def _commands(piece):
    """The piece's words, command by command."""
    try:
        lexer = shlex.shlex(piece, posix=True, punctuation_chars=";&|")
        lexer.whitespace_split = True
        words = list(lexer)
    except ValueError:  # an apostrophe: prose
        return
    command = []
    for word in words:
        if word in SEPARATORS:
            yield command
            command = []
        else:
            command.append(word)
    yield command
