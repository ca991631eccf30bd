#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""sizes.py PACKED WWW...: prints the sizes of the client libraries that a game includes, and of the pages that browsers load. PACKED
is the folder of pack.sh; a page that was not built is omitted. Exit: 1 a file is missing or empty, or the table of clients/libraries.md or
the page's README has another size.
"""

import pathlib
import re
import sys

CLIENTS = pathlib.Path(__file__).resolve().parent.parent.parent / "clients"
# Files that are not copied into a game.
APART = ("README.md", "source.md", "generate.py", "generate_messages.py", "__pycache__", "Samples~", "Example")

# Where the size of each folder of pages is documented.
COMPRESSED = r"([0-9.]+) kB, compressed"
PAGES = {"www": ("dashboard/README.md", COMPRESSED), "racer": ("racer/page.md", COMPRESSED),
         "client": ("libraries.md", r"([0-9.]+) in a page, bundled and compressed")}

# Relative tolerance of the documented sizes, because the libraries grow over time.
TOLERANCE = 0.15


def documented(folder):
    """Size in kB of the library in `folder` by the table of clients/libraries.md; None: not documented."""
    table = (CLIENTS / "libraries.md").read_text(encoding="utf-8")
    found = re.search(r"^\| \[[^]]+\]\(%s/README\.md\) (?:\|[^|]*){2}\| ([0-9.]+)," % folder, table, re.M)
    return float(found.group(1)) if found else None


def documented_page(folder):
    """Size in kB of the pages in `folder` by their README; None: not documented."""
    if folder not in PAGES:
        return None
    document, pattern = PAGES[folder]
    found = re.search(pattern, (CLIENTS / document).read_text(encoding="utf-8"))
    return float(found.group(1)) if found else None


def files(folder):
    return [path for path in folder.rglob("*")
            if path.is_file() and not any(part in APART for part in path.relative_to(folder).parts)]


def main():
    packed, pages = pathlib.Path(sys.argv[1]), [pathlib.Path(one) for one in sys.argv[2:]]
    rows = [("JavaScript: npm's file", "js", list(packed.glob("*.tgz"))), ("Python: wheel", "python", list(packed.glob("*.whl"))),
            ("Unity: package", "unity", files(CLIENTS / "unity")), ("Godot: addon", "godot", files(CLIENTS / "godot" / "addons")),
            ("Unreal: plugin", "unreal", files(CLIENTS / "unreal"))]
    # Browsers request the compressed file.
    rows += [("pages: " + one.name, one.name, list(one.rglob("*.gz"))) for one in pages if one.is_dir()]
    print("%-24s %7s %9s" % ("", "files", "kB"))
    well = True
    for name, folder, those in rows:
        size = sum(path.stat().st_size for path in those) / 1000
        known = documented_page(folder) if name.startswith("pages: ") else documented(folder)
        problem = "" if known and abs(size - known) <= TOLERANCE * known else "  its README says %s" % known
        print("%-24s %7d %9.1f%s" % (name, len(those), size, problem))
        well = well and size > 0 and not problem
    return 0 if well else 1


if __name__ == "__main__":
    sys.exit(main())
