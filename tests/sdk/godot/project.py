# SPDX-License-Identifier: MIT
"""An empty Godot project with the addon, run without a screen: with Debian's godot3-server, and with $GODOT4 if that is set."""

import os
import pathlib
import shutil
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
GODOT = HERE.parent.parent.parent / "clients" / "godot"

SCENE = '''[gd_scene load_steps=2 format=2]

[ext_resource path="res://main.gd" type="Script" id=1]

[node name="Main" type="Node"]
script = ExtResource( 1 )
'''
SCENE_4 = '''[gd_scene load_steps=2 format=3]

[ext_resource type="Script" path="res://main.gd" id="1"]

[node name="Main" type="Node"]
script = ExtResource("1")
'''
# Without a screen nothing else limits the frame rate. max_fps: Godot 4, force_fps: Godot 3.
PROJECT = '''config_version=%d

[application]

config/name="Hedgehog"
run/main_scene="res://main.tscn"
run/max_fps=60

[debug]

settings/fps/force_fps=60
'''


def engines():
    """The command of each available Godot, by name."""
    found = {}
    if shutil.which("godot3-server"):
        found["godot3"] = ["godot3-server"]
    if os.environ.get("GODOT4"):
        found["godot4"] = [os.environ["GODOT4"], "--headless"]
    return found


def make_project(folder, engine, main, others=()):
    """A project whose only scene runs the text `main`; `others` are scripts beside it."""
    folder = pathlib.Path(folder)
    shutil.copytree(GODOT / "addons", folder / "addons")
    make_scene(folder, engine)
    (folder / "main.gd").write_text(main, encoding="utf-8")
    for other in others:
        shutil.copy(other, folder)


def make_scene(folder, engine):
    """A project with one scene, which runs main.gd."""
    (folder / "project.godot").write_text(PROJECT % (4 if engine == "godot3" else 5), encoding="utf-8")
    (folder / "main.tscn").write_text(SCENE if engine == "godot3" else SCENE_4, encoding="utf-8")


def start(folder, engine, environment):
    """Starts the project; its output is in `stdout`."""
    return subprocess.Popen(engines()[engine] + ["--path", str(folder)],
                            env=dict(environment, HOME=str(folder), XDG_DATA_HOME=str(folder)),
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
