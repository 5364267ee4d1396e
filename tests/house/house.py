"""What the gates of the house share: the files of the repository, and what of a file is prose."""

import pathlib
import re
import sys

FOLDERS = ("core", "formats", "replay", "cli", "tests", "samples", "docs")
SOURCES = ("core", "formats", "replay", "cli")
SKIPPED = re.compile(r"build.*|out|__pycache__|\..*")
CPP = (".h", ".cpp", ".glsl")
HASHED = (".py", ".cmake", ".sh", ".txt", "")
# In this order, so that a quote inside a comment opens no string and a `//` in a string no comment.
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"(?P<delimiter>\w*)\(.*?\)(?P=delimiter)"'
                   r'|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.DOTALL)


def files(root):
    """All files of the repository, without what builds leave in it."""
    found = []
    for entry in sorted(pathlib.Path(root).iterdir()):
        if SKIPPED.fullmatch(entry.name):
            continue
        if entry.is_dir():
            found += files(entry)
        else:
            found.append(entry)
    return found


def relative(root, file):
    return file.relative_to(root).as_posix()


def cpp_sources(root, folders=SOURCES):
    return [file for file in files(root)
            if file.suffix in (".h", ".cpp") and relative(root, file).split("/")[0] in folders]


def _blank(text):
    """The text's line breaks alone: what is cut out keeps the numbers of the lines."""
    return "\n" * text.count("\n")


def comments(text):
    """The comments of a C++ or GLSL text, each line where it was."""
    kept, end = [], 0
    for match in TOKEN.finditer(text):
        kept.append(_blank(text[end:match.start()]))
        kept.append(match[0] if match[0].startswith(("//", "/*")) else _blank(match[0]))
        end = match.end()
    return "".join(kept)


def without_comments(text):
    """The code of a C++ text: comments and the insides of strings cut out."""
    return TOKEN.sub(lambda match: _blank(match[0]) or " ", text)


def _hash_comments(text):
    """Comments behind `#`, and the docstrings, of Python, CMake and shell texts."""
    lines, quoted = [], False
    for line in text.split("\n"):
        mark = line.count('"""')
        hashed = re.search(r"(?:^|\s)#.*", line)
        lines.append(line if quoted or mark else hashed[0] if hashed else "")
        quoted ^= mark == 1
    return "\n".join(lines)


def prose(file):
    """What people read in a page (all of it) or in a source (its comments), as numbered lines."""
    if file.suffix == ".md":
        text = file.read_text()
    elif file.suffix in CPP:
        text = comments(file.read_text())
    elif file.suffix in (".py", ".cmake", ".sh") or file.name in ("CMakeLists.txt", "bootstrap", "run"):
        text = _hash_comments(file.read_text())
    else:
        return []
    return list(enumerate(text.split("\n"), 1))


def main(check, usage):
    """A gate's command: prints its problems, exits 1 if there are any."""
    if len(sys.argv) != 2:
        sys.exit(usage)
    problems = check(sys.argv[1])
    for problem in problems:
        print(problem)
    sys.exit(1 if problems else 0)
