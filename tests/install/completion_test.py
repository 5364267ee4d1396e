#!/usr/bin/env python3
"""What the completions offer in bash, and in zsh and fish where they are installed.

usage: completion_test.py BUILD
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SHELLS = pathlib.Path(sys.argv.pop(1)) / "pages/shells" if len(sys.argv) > 1 else pathlib.Path("build/pages/shells")
SHELLS = SHELLS.resolve()
# Puts the words into the variables that bash gives to a completion, and prints what it offers.
ASK_BASH = """source "$1"; shift
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _pentimento; printf '%s\\n' "${COMPREPLY[@]}"
"""
# Zsh completes only at a prompt: one is opened, and what it lists is read.
ASK_ZSH = r"""
zmodload zsh/zpty
zpty shell 'zsh -f -i'
send() { zpty -w shell "$1" }
send 'PROMPT= RPROMPT=; fpath=('"$1"' $fpath); autoload -Uz compinit; compinit -D -u'
send 'zstyle ":completion:*" list-prompt ""; LISTMAX=10000; bindkey "^I" list-choices; print RE''ADY'
while zpty -r shell line; do [[ $line = *READY* ]] && break; done
zpty -w -n shell "$2"$'\t'
sleep 1
while zpty -r -t shell line; do print -r -- $line; done
zpty -d shell
"""


def bash(*words):
    return subprocess.run(["bash", "-c", ASK_BASH, "bash", SHELLS / "pentimento.bash", *words],
                          capture_output=True, text=True, check=True).stdout.split()


class BashTest(unittest.TestCase):
    def test_commands(self):
        self.assertEqual(["render", "relight"], bash("pentimento", "re"))

    def test_options_of_the_command(self):
        self.assertEqual(["--profile", "--progress", "--print"], sorted(bash("pentimento", "render", "--pr"),
                                                                        key="--profile --progress --print".index))
        self.assertEqual([], bash("pentimento", "validate", "--prof"))

    def test_choices_as_a_word_and_after_an_equals_sign(self):
        self.assertEqual(["display-p3"], bash("pentimento", "render", "--profile", "d"))
        self.assertEqual(["paper"], bash("pentimento", "render", "--scheme", "=", "p"))
        self.assertEqual(["conservative", "paper"], bash("pentimento", "render", "--scheme", "="))
        self.assertEqual(["brushes"], bash("pentimento", "list", "b"))

    def test_settings_of_the_model(self):
        self.assertIn("model.gravity_cutoff=", bash("pentimento", "render", "--set", "model.gravity_"))

    def test_files_folders_and_values_that_nobody_knows(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "a.jsonl").touch()
            (folder / "ab").mkdir()
            start = f"{folder}/a"
            self.assertEqual([start + ".jsonl", start + "b"], sorted(bash("pentimento", "render", start)))
            self.assertEqual([start + ".jsonl", start + "b"], sorted(bash("pentimento", "render", "-o", start)))
            self.assertEqual([start + "b"], bash("pentimento", "render", "x.jsonl", "--scratch", start))
            self.assertEqual([], bash("pentimento", "render", "--width", ""))


@unittest.skipUnless(shutil.which("fish"), "fish is not installed")
class FishTest(unittest.TestCase):
    def offers(self, line):
        with tempfile.TemporaryDirectory() as home:
            text = subprocess.run(["fish", "--no-config", "-c",
                                   f"source {SHELLS / 'pentimento.fish'}; complete -C '{line}'"],
                                  capture_output=True, text=True, check=True, env={**os.environ, "HOME": home}).stdout
        return [row.split("\t")[0] for row in text.splitlines()]

    def test_commands_options_and_choices(self):
        self.assertEqual(["relight", "render"], sorted(self.offers("pentimento re")))
        self.assertIn("--profile", self.offers("pentimento render --pro"))
        self.assertNotIn("--profile", self.offers("pentimento validate --pro"))
        self.assertEqual(["display-p3"], self.offers("pentimento render --profile d"))
        self.assertIn("brushes", self.offers("pentimento list b"))


@unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
class ZshTest(unittest.TestCase):
    def offers(self, line):
        return subprocess.run(["zsh", "-f", "-c", ASK_ZSH, "zsh", SHELLS, line],
                              capture_output=True, text=True, check=True, timeout=60).stdout

    def test_commands_options_and_choices(self):
        self.assertIn("replay a log, write pictures and state", self.offers("pentimento re"))
        self.assertIn("--progress", self.offers("pentimento render --pro"))
        self.assertNotIn("--profile", self.offers("pentimento validate --"))
        self.assertIn("adobe-rgb", self.offers("pentimento render --profile "))


if __name__ == "__main__":
    unittest.main()
