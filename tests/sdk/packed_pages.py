#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prepares the pages of a client library for its package: packed_pages.py LIBRARY COPY [PAGE...].

COPY is a copy of the folder LIBRARY; the package has its PAGEs and README.md. In these a link to any other file, which the package does
not have, becomes its words and that file's path in the sources.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
LINK = re.compile(r"\[([^]]+)\]\(([^):#]+)(#[^)]*)?\)")


def main():
    library, copy = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    pages = ["README.md", *sys.argv[3:]]

    def words(link):
        text, target = link.group(1), link.group(2)
        if target in pages:
            return link.group(0)
        path = (library / target).resolve().relative_to(ROOT).as_posix()
        return "`%s`" % path if path.endswith(text) else "%s (`%s`)" % (text, path)

    for page in pages:
        text = (copy / page).read_text(encoding="utf-8")
        found = LINK.sub(words, text)
        if found != text:
            found += "\nPaths are those in the sources of Hedgehog.\n"
        (copy / page).write_text(found, encoding="utf-8")


if __name__ == "__main__":
    main()
