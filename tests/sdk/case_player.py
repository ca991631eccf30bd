# SPDX-License-Identifier: MIT
"""Runs the cases of conformance.json on libraries that are tested by separate programs: a program reads its case from HEDGEHOG_CASE,
connects to HEDGEHOG_ADDRESS with the timeout HEDGEHOG_TIMEOUT_S, prints "passed" and exits with 0."""

import json
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
CASES = json.loads((HERE / "conformance.json").read_text(encoding="utf-8"))["cases"]
# Printed by a script engine for an error in the script.
MISTAKE = "SCRIPT ERROR"


def failure_of(case, start):
    """The error; empty: passed. `start` starts the program with an environment."""
    daemon = subprocess.Popen([sys.executable, str(HERE / "fake_daemon.py"), case["name"]],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    address = "127.0.0.1:" + daemon.stdout.readline().strip()
    program = start(dict(os.environ, HEDGEHOG_ADDRESS=address, HEDGEHOG_CASE=json.dumps(case),
                         HEDGEHOG_TIMEOUT_S=str(case.get("timeout_s", 60)), **case.get("environment", {})))
    try:
        printed, _ = program.communicate(timeout=120)
        _, errors = daemon.communicate(timeout=70)
    except subprocess.TimeoutExpired:
        program.kill()
        daemon.kill()
        return "no end: " + program.communicate()[0]
    passed = program.returncode == 0 and "passed" in printed.splitlines() and MISTAKE not in printed
    return "" if passed and daemon.returncode == 0 else printed + errors + "exit %d" % program.returncode


def play_all(sdk, start):
    """Prints a line for each case: "ok" or "not ok", SDK and case. True: all passed."""
    passed = True
    table = os.environ.get("HEDGEHOG_CONFORMANCE_TABLE", os.devnull)
    for case in CASES:
        if sdk in case.get("without", []):
            continue
        failure = failure_of(case, start)
        with open(table, "a", encoding="utf-8") as lines:
            lines.write("%s\t%s\t%s\n" % (sdk, case["name"], "failed" if failure else "ok"))
        print("%s %s %s" % ("not ok" if failure else "ok", sdk, case["name"]), flush=True)
        if failure:
            print(failure, file=sys.stderr)
            passed = False
    return passed
