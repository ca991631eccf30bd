# SPDX-License-Identifier: MIT
"""The game of the quick start in clients/unreal/README.md: its file, and its program over the stub of the engine."""

import pathlib
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
FILES = ("Source/MyGame/my_car.h",)


def add_members(folder, members):
    """The game's class with more members, as the README adds them."""
    path = folder / FILES[0]
    text = path.read_text(encoding="utf-8")
    assert text.endswith("};\n"), text
    path.write_text(text[:-len("};\n")] + members + "};\n", encoding="utf-8")


def start(folder, environment):
    """Compiles the game in that folder, with the plugin that it has, and starts it; what it prints can be read."""
    out = folder / "Binaries"
    subprocess.run(["sh", str(HERE / "build.sh"), str(out), str(folder)], check=True)
    return subprocess.Popen([str(out / "game")], env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
