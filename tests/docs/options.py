#!/usr/bin/env python3
"""Options in the pages that the command does not have, and options that docs/cli.md leaves out.

The truth is the `--help` of each subcommand. docs/cli.md names every option; a section that is named
after commands names only options of those; a default in brackets (`--dpi` (300)) stands in the help
too; the choices of `--refine guided|direct` are those of the help. In all pages a line that begins
`pentimento relight`, in a block of code or in backticks, has only options of `relight`.

usage: options.py REPOSITORY COMMAND
"""

import pathlib
import re
import subprocess
import sys

CLI = "docs/cli.md"
HISTORY = ("CHANGELOG.md",)
COMMANDS = ("render", "relight", "info", "validate", "convert", "list", "compare", "verify", "batch", "batch-report")
EVERYWHERE = {"--help", "--describe"}
HELP_LINE = re.compile(r"^  (?:-\w,)?(--[\w-]+)(.*)$")
OPTION = re.compile(r"(?<![\w-])(--[a-z][\w-]*)")
CODE = re.compile(r"`([^`]+)`(?:\s+\((\d[\d.]*)\))?")
CALL = re.compile(r"(?:^|[\s/`|])pentimento (%s)\b([^|`\n]*)" % "|".join(sorted(COMMANDS, reverse=True)))
CHOICES = re.compile(r"^(--[\w-]+) ([\w.-]+(?:\|[\w.-]+)+)$")


def helped(command):
    """{option: the rest of its lines in the help} of each subcommand."""
    options = {}
    for name in COMMANDS:
        text = subprocess.run([command, name, "--help"], capture_output=True, text=True, check=True).stdout
        found, last = {}, None
        for line in text.split("Options:")[1].split("\n"):
            if match := HELP_LINE.match(line):
                last = match[1]
                found[last] = match[2]
            elif last:
                found[last] += line
        options[name] = found
    return options


def sections(text):
    """(the commands that a section of the page is about, its text); none: about all."""
    for part in re.split(r"^## ", text, flags=re.MULTILINE):
        heading, _, body = part.partition("\n")
        about = [name for name in re.split(r",\s*", heading) if name in COMMANDS]
        yield about or list(COMMANDS), body


def check_page(text, options):
    """What docs/cli.md says wrongly."""
    everything = set().union(*options.values()) - EVERYWHERE
    problems = [f"{CLI}: leaves out {option}" for option in sorted(everything - set(OPTION.findall(text)))]
    for about, body in sections(text):
        own = set().union(*(options[name] for name in about))
        problems += [f"{CLI}: {' and '.join(about)} has no option {option}"
                     for option in sorted(set(OPTION.findall(body)) - own - EVERYWHERE)]
        for code, default in CODE.findall(body):
            option = OPTION.match(code)
            line = " ".join(options[name].get(option[1], "") for name in about) if option else ""
            if option and default and f"({default}" not in line:
                problems.append(f"{CLI}: {option[1]} ({default}), but the help says:{line}")
            if match := CHOICES.match(code):
                problems += [f"{CLI}: {match[1]} has no choice {choice} in the help:{line}"
                             for choice in match[2].split("|")
                             if not re.search(rf"(?<![\w.]){re.escape(choice)}(?![\w])", line)]
    return problems


def check_calls(name, text, options):
    """What a page tells its reader to type and the command would refuse."""
    return [f"{name}: pentimento {command} has no option {option}"
            for command, rest in CALL.findall(text.replace("\\\n", " ")) for option in OPTION.findall(rest)
            if option not in options[command]]


def pages(root):
    return [page for page in sorted(root.rglob("*.md"))
            if not any(part.startswith(("build", ".", "out")) for part in page.relative_to(root).parts)]


def check(root, options):
    root = pathlib.Path(root)
    problems = check_page((root / CLI).read_text(), options)
    for page in pages(root):
        name = page.relative_to(root).as_posix()
        if name not in HISTORY:
            problems += check_calls(name, page.read_text(), options)
    return problems


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    found = check(sys.argv[1], helped(sys.argv[2]))
    for problem in found:
        print(problem)
    sys.exit(1 if found else 0)
