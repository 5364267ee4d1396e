#!/usr/bin/env python3
"""Completions of the command for bash, zsh and fish, made of its own tables of options.

Writes pentimento.bash, _pentimento (zsh) and pentimento.fish into FOLDER.

usage: completions.py COMMAND FOLDER
"""

import pathlib
import re
import sys

import tables

BASH = r"""# Completions of pentimento for bash. Made from its tables of options.
_pentimento() {
  local cur=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD - 1]} words= kind=
  # Bash parts words at "=": the option stands before it, and a setting of the model is one word.
  if [ "$cur" = = ]; then cur=; fi
  if [ "$option" = = ]; then option=${COMP_WORDS[COMP_CWORD - 2]}; fi
  if [ "$COMP_CWORD" = 1 ]; then
    COMPREPLY=($(compgen -W "@COMMANDS@ --help --version" -- "$cur"))
    return
  fi
  case ${COMP_WORDS[1]}:$option in
@VALUES@
    *)
      case ${COMP_WORDS[1]} in
@WORDS@
      esac
      ;;
  esac
  if [ "$kind" = open ]; then return; fi
  if [ "$kind" = file ] && [ "${cur#-}" = "$cur" ]; then
    compopt -o filenames
    COMPREPLY=($(compgen -W "$words" -- "$cur") $(compgen -f -- "$cur"))
  elif [ "$kind" = folder ]; then
    compopt -o filenames
    COMPREPLY=($(compgen -d -- "$cur"))
  else
    COMPREPLY=($(compgen -W "$words" -- "$cur"))
    case ${COMPREPLY[0]-} in *=) compopt -o nospace ;; esac
  fi
} 2>/dev/null
complete -F _pentimento pentimento
"""


def words_of(option, settings):
    return settings if option["value"].startswith("model.") else option["choices"]


def kind_of(option):
    if tables.takes_folder(option):
        return "folder"
    return "file" if tables.takes_file(option) else "open"


def parted(command):
    """The options of a command that have a dash, and the words that have none."""
    dashed = [option for option in command["options"] if option["names"]]
    return dashed, [option for option in command["options"] if not option["names"]]


def bash(commands, settings):
    values, words = [], []
    for command in commands:
        name = command["name"]
        dashed, plain = parted(command)
        for option in dashed:
            if option["value"]:
                offered = words_of(option, settings)
                action = f"words='{' '.join(offered)}'" if offered else f"kind={kind_of(option)}"
                values.append(f"    {'|'.join(f'{name}:{n}' for n in option['names'])}) {action} ;;")
        offered = [n for option in dashed for n in option["names"] if n.startswith("--")]
        offered += [word for option in plain for word in option["choices"]]
        files = " kind=file" if any(map(tables.takes_file, plain)) else ""
        words.append(f"        {name}) words='{' '.join(offered)}'{files} ;;")
    return (BASH.replace("@COMMANDS@", " ".join(c["name"] for c in commands))
            .replace("@VALUES@", "\n".join(values)).replace("@WORDS@", "\n".join(words)))


def quoted(text):
    """One word of zsh or fish."""
    return "'" + text.replace("\\", "\\\\").replace("'", "'\\''") + "'"


def zsh_action(option, settings):
    if offered := words_of(option, settings):
        # What ends with "=" goes on with a value.
        return f":_values -S '' setting {' '.join(offered)}" if offered is settings else f":({' '.join(offered)})"
    return {"folder": ":_files -/", "file": ":_files", "open": ": "}[kind_of(option)]


def zsh_option(option, settings):
    about = re.sub(r"([\[\]:])", r"\\\1", option["about"])
    value = re.sub(r"([\[\]:])", r"\\\1", option["value"])
    many = "*" if option["repeatable"] else ""
    if not option["names"]:
        return quoted(f"{many}:{about}{zsh_action(option, settings)}")
    tail = f"[{about}]" + (f":{value}{zsh_action(option, settings)}" if option["value"] else "")
    if len(option["names"]) == 1 or many:
        return " ".join(quoted(f"{many}{name}{tail}") for name in option["names"])
    names = option["names"]
    return f"'({' '.join(names)})'{{{','.join(names)}}}{quoted(tail)}"


def zsh(commands, settings):
    lines = ["#compdef pentimento", "# Completions of pentimento for zsh. Made from its tables of options.",
             "local -a commands", "commands=("]
    lines += ["  " + quoted(c["name"] + ":" + c["about"].replace(":", "\\:")) for c in commands]
    lines += [")", "if (( CURRENT == 2 )); then", "  _describe command commands", "  return", "fi",
              "local command=$words[2]", "shift words", "(( CURRENT-- ))", "case $command in"]
    for command in commands:
        lines.append(f"  {command['name']})")
        lines.append("    _arguments -s \\")
        lines += [f"      {zsh_option(option, settings)} \\" for option in command["options"]]
        lines += ["      && return 0", "    ;;"]
    return "\n".join(lines + ["esac", ""])


def fish_value(option, settings):
    if offered := words_of(option, settings):
        return f" -x -a {quoted(' '.join(offered))}"
    if not option["value"]:
        return " -f" if option["names"] else ""
    return {"folder": " -x -a '(__fish_complete_directories)'", "file": " -r -F", "open": " -x"}[kind_of(option)]


def fish(commands, settings):
    lines = ["# Completions of pentimento for fish. Made from its tables of options."]
    for command in commands:
        name = command["name"]
        lines.append(f"complete -c pentimento -n __fish_use_subcommand -f -a {name} -d {quoted(command['about'])}")
        for option in command["options"]:
            flags = "".join(f" -s {n[1:]}" if not n.startswith("--") else f" -l {n[2:]}" for n in option["names"])
            value = fish_value(option, settings)
            if flags or value:
                lines.append(f"complete -c pentimento -n '__fish_seen_subcommand_from {name}'{flags}{value}"
                             f" -d {quoted(option['about'])}")
    return "\n".join(lines) + "\n"


def main(command, folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    found, settings = tables.commands(command), tables.model_words(command)
    for name, shell in (("pentimento.bash", bash), ("_pentimento", zsh), ("pentimento.fish", fish)):
        (folder / name).write_text(shell(found, settings))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
