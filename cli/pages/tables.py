"""The tables of options that `pentimento --describe` prints, as Python values."""

import json
import subprocess


def asked(command, *words):
    """What the command says, taken as JSON."""
    return json.loads(subprocess.run([command, *words], capture_output=True, text=True, check=True).stdout)


def commands(command):
    """[{name, about, long, options}] of each subcommand, in the order of the overview."""
    found = []
    for row in asked(command, "--describe"):
        table = asked(command, row["name"], "--describe")
        found.append({**row, "long": table["about"], "options": table["options"]})
    return found


def model_words(command):
    """What `--set` takes before its value: `model.NAME=`."""
    return [f"model.{row['name']}=" for row in asked(command, "list", "parameters", "--json")["parameters"]
            if "model" in row["in"]]


def takes_folder(option):
    return option["value"] in ("DIR", "RUN")


def takes_file(option):
    """A word without a dash whose value has no name of its own is a file, too."""
    return "FILE" in option["value"] or option["value"].endswith((".h5", "LOG")) or not (
        option["names"] or option["value"])
