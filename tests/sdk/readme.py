# SPDX-License-Identifier: MIT
"""The quick start of a client library's README: a program, the names of its files, and the commands that run it."""

import os
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
CLIENTS = ROOT / "clients"


class Readme:
    def __init__(self, path):
        self.text = (CLIENTS / path).read_text(encoding="utf-8")

    def program(self, language, number=0):
        """The first code block in that language, or a later one."""
        return re.findall(r"```%s\n(.*?)```" % language, self.text, re.S)[number]

    def commands(self):
        """The lines of the first block of shell commands, without their comments."""
        block = re.search(r"```sh\n(.*?)```", self.text, re.S).group(1)
        return [line.partition(" #")[0].strip() for line in block.splitlines()]

    def names(self, file):
        """True if the text before the first program names its file."""
        return "`%s`" % file in self.text.partition("```")[0]

    def project(self, folder, language, files):
        """The folder `game` with a code block in each of the files, beside the sources, where the commands expect them."""
        os.symlink(ROOT, pathlib.Path(folder) / "hedgehog")
        game = pathlib.Path(folder) / "game"
        for number, file in enumerate(files):
            assert self.names(file), "the README does not name %s" % file
            (game / file).parent.mkdir(parents=True, exist_ok=True)
            (game / file).write_text(self.program(language, number), encoding="utf-8")
        return game
