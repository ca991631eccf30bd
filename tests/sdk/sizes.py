#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""sizes.py PACKED WWW...: how large the client libraries are that a game takes with it, and the pages that browsers load. PACKED is
of pack.sh; a page that was not built is left out. Exit: 1 something is missing or empty.
"""

import pathlib
import sys

CLIENTS = pathlib.Path(__file__).resolve().parent.parent.parent / "clients"
# What is not copied into a game.
APART = ("README.md", "generate.py", "__pycache__", "Samples~", "Example")


def files(folder):
    return [path for path in folder.rglob("*")
            if path.is_file() and not any(part in APART for part in path.relative_to(folder).parts)]


def main():
    packed, pages = pathlib.Path(sys.argv[1]), [pathlib.Path(one) for one in sys.argv[2:]]
    rows = [("JavaScript: npm's file", list(packed.glob("*.tgz"))), ("Python: wheel", list(packed.glob("*.whl"))),
            ("Unity: package", files(CLIENTS / "unity")), ("Godot: addon", files(CLIENTS / "godot" / "addons")),
            ("Unreal: plugin", files(CLIENTS / "unreal"))]
    # A browser asks for the compressed file.
    rows += [("page: " + one.name, list(one.rglob("*.gz"))) for one in pages if one.is_dir()]
    print("%-24s %7s %9s" % ("", "files", "kB"))
    well = True
    for name, those in rows:
        size = sum(path.stat().st_size for path in those)
        print("%-24s %7d %9.1f" % (name, len(those), size / 1000))
        well = well and size > 0
    return 0 if well else 1


if __name__ == "__main__":
    sys.exit(main())
