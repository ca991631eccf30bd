# SPDX-License-Identifier: MIT
"""The quick start of a client library's README: a program, the name of its file, and the commands that run it."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
CLIENTS = ROOT / "clients"


class Readme:
    def __init__(self, path):
        self.text = (CLIENTS / path).read_text(encoding="utf-8")

    def program(self, language):
        """The first code block in that language."""
        return re.search(r"```%s\n(.*?)```" % language, self.text, re.S).group(1)

    def commands(self):
        """The lines of the first block of shell commands, without their comments."""
        block = re.search(r"```sh\n(.*?)```", self.text, re.S).group(1)
        return [line.partition(" #")[0].strip() for line in block.splitlines()]

    def names(self, file):
        """True if the text before the first program names its file."""
        return "`%s`" % file in self.text.partition("```")[0]
