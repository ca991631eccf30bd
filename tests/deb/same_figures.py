#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""same_figures.py BUILD SETTINGS FILE: compares the results of BUILD's programs with those in FILE, which figures.sh wrote on another
architecture with a daemon that used the settings file SETTINGS. Prints the largest deviation of each line. Exit: 0 the same within
TOLERANCE, 1 not, 64 usage."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

# Relative for a number of at least 1, otherwise absolute. The mathematical libraries of two architectures may round the last bit
# differently. A preview begins at the ball's temperature, and calibration measures: both have noise that depends on their start time.
TOLERANCE = {"preview": 0.02, "calibrate": 0.02}
COMPUTED = 1e-9
# Divisor of a deviation where 1 would hide it: 2 % of this are a fifth of a winding's 1.5 mH, which the thermal model tolerates
# (model/thermal-model.md). The error of an emulated measurement on a busy machine is a tenth.
SCALE = {".figures.inductance_h": 0.015}
PROGRAMS = ("daemon", "clients/ctl", "clients/design")


def deviation(one, other, place=""):
    """The largest difference of two numbers at the same place, and that place."""
    if isinstance(one, bool) or isinstance(other, bool) or not isinstance(one, (int, float)):
        if isinstance(one, dict) and isinstance(other, dict) and one.keys() == other.keys():
            return max((deviation(one[key], other[key], f"{place}.{key}") for key in one), default=(0.0, place))
        if isinstance(one, list) and isinstance(other, list) and len(one) == len(other):
            return max((deviation(a, b, f"{place}[{i}]") for i, (a, b) in enumerate(zip(one, other))), default=(0.0, place))
        return (0.0 if one == other else float("inf"), place)
    if not isinstance(other, (int, float)):
        return (float("inf"), place)
    return (abs(one - other) / max(SCALE.get(place, 1.0), abs(one)), place)


def native_figures(build, settings, folder):
    """The output lines of figures.sh with the programs of `build`."""
    path = os.pathsep.join([str(build / part) for part in PROGRAMS] + [os.environ["PATH"]])
    environment = {**os.environ, "PATH": path, "RUNTIME_DIRECTORY": folder, "STATE_DIRECTORY": folder,
                   "HEDGEHOG_ADDRESS": f"{folder}/hedgehogd.sock"}
    with open(f"{folder}/log", "w", encoding="utf-8") as log, \
            subprocess.Popen(["hedgehogd", "--config", settings, "--simulate", "--listen", "127.0.0.1:0"], env=environment,
                             stdout=subprocess.PIPE, stderr=log) as daemon:
        try:
            daemon.stdout.readline()
            script = pathlib.Path(__file__).with_name("figures.sh")
            return subprocess.run([script], env=environment, check=True, stdout=subprocess.PIPE, text=True).stdout
        finally:
            daemon.terminate()


def main():
    if len(sys.argv) != 4:
        print("same_figures.py BUILD SETTINGS FILE", file=sys.stderr)
        return 64
    with tempfile.TemporaryDirectory() as folder:
        expected = native_figures(pathlib.Path(sys.argv[1]).resolve(), sys.argv[2], folder).splitlines()
    found = pathlib.Path(sys.argv[3]).read_text(encoding="utf-8").splitlines()
    code = 0 if len(expected) == len(found) else 1
    for one, other in zip(map(json.loads, expected), map(json.loads, found)):
        allowed = TOLERANCE.get(one["name"].split()[0], COMPUTED)
        size, place = deviation(one, other)
        good = size <= allowed
        code = code if good else 1
        print(f"tests/deb: {one['name']}: {'the same' if size == 0 else f'{size:.2g} at {place}'}"
              f"{'' if good else f', more than {allowed:g}'}")
    return code


sys.exit(main())
