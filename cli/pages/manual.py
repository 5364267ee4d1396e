#!/usr/bin/env python3
"""Manual pages of the command and of each subcommand, made of its own tables of options.

Writes pentimento.1 and pentimento-NAME.1 into FOLDER.

usage: manual.py COMMAND VERSION FOLDER
"""

import pathlib
import sys

import tables

EXIT_STATUS = (
    ("0", "done"),
    ("1", "compare, verify: it differs; batch, batch-report: a job failed"),
    ("2", "the command line is wrong"),
    ("3", "the input is wrong"),
    ("4", "a limit is exceeded, before or while it was worked on"),
    ("5", "a file cannot be read or written"),
    ("6", "a value that is not finite came up in the simulation"),
    ("75", "interrupted by a signal: the same command again does it"),
)


def text(words):
    """Words as roff takes them: no escapes, no requests, dashes that can be copied."""
    words = words.replace("\\", "\\e").replace("-", "\\-")
    return "\n".join("\\&" + line if line.startswith((".", "'")) else line for line in words.split("\n"))


def header(name, version, about):
    return [f'.TH "{name.upper()}" 1 "" "pentimento {version}" "User Commands"',
            ".SH NAME", f"{text(name)} \\- {text(about)}"]


def tagged(tag, body):
    return [".TP", tag, text(body)]


def option_tag(option):
    """`-o FILE, --output FILE`, the names bold and the value slanted."""
    if not option["names"]:
        return f"\\fI{text(option['word'])}\\fR"
    value = f" \\fI{text(option['value'])}\\fR" if option["value"] else ""
    return ", ".join(f"\\fB{text(name)}\\fR{value}" for name in option["names"])


def synopsis(command):
    words = [f"\\fI{text(o['word'])}\\fR" if o["required"] else f"[\\fI{text(o['word'])}\\fR]"
             for o in command["options"] if not o["names"]]
    return f"\\fBpentimento {text(command['name'])}\\fR [\\fIoption\\fR]... {' '.join(words)}"


def example_lines(examples):
    return [".nf", *text("\n".join(line.removeprefix("  ") for line in examples.strip("\n").split("\n"))).split("\n"),
            ".fi"]


def command_page(command, version):
    about, _, examples = command["long"].partition("\n\nExamples:\n")
    lines = header(f"pentimento-{command['name']}", version, command["about"])
    lines += [".SH SYNOPSIS", synopsis(command), ".SH DESCRIPTION", text(about)]
    lines.append(".SH OPTIONS")
    for option in command["options"]:
        lines += tagged(option_tag(option), option["about"])
    if examples:
        lines += [".SH EXAMPLES", *example_lines(examples)]
    return lines + exit_and_others([])


def exit_and_others(others):
    lines = [".SH EXIT STATUS"]
    for code, meaning in EXIT_STATUS:
        lines += tagged(code, meaning)
    names = others or ["pentimento"]
    return lines + [".SH SEE ALSO", ", ".join(f"\\fB{text(name)}\\fR(1)" for name in names), ""]


def overview_page(commands, version):
    lines = header("pentimento", version, "replays recorded oil-painting sessions and renders them at any size")
    lines += [".SH SYNOPSIS", "\\fBpentimento\\fR \\fIcommand\\fR [\\fIoption\\fR]...", ".br",
              "\\fBpentimento\\fR \\-\\-help | \\-\\-version", ".SH COMMANDS"]
    for command in commands:
        lines += tagged(f"\\fBpentimento {text(command['name'])}\\fR", command["about"])
    return lines + exit_and_others([f"pentimento-{command['name']}" for command in commands])


def main(command, version, folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    found = tables.commands(command)
    (folder / "pentimento.1").write_text("\n".join(overview_page(found, version)))
    for one in found:
        (folder / f"pentimento-{one['name']}.1").write_text("\n".join(command_page(one, version)))


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
