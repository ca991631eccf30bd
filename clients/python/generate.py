#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes hedgehog/methods.py from the OpenRPC document.

generate.py [--check]: with --check nothing is written; exit 1 says that the file is not what the document gives.
"""

import json
import pathlib
import sys
import textwrap

HERE = pathlib.Path(__file__).resolve().parent
DOCUMENT = HERE.parent.parent / "protocol" / "schema" / "openrpc.json"
MODULE = HERE / "hedgehog" / "methods.py"

HEAD = '''\
# SPDX-License-Identifier: MIT
# Written by generate.py from protocol/schema/openrpc.json.
"""The daemon's methods. Parameters that are None are left out; protocol/README.md has all of them at length."""

from typing import Any, List, Mapping, Optional, Sequence, Union

#: "left", [0, 1, 0], {"azimuth_deg": 90} or {"pin": 34}: where the pins push out.
Direction = Union[str, Sequence[float], Mapping[str, Any]]
'''

CLASS = '''

class {name}:
    """{doc}"""

    {do}def call(self, method: str, /, **params: Any) -> Any:
        raise NotImplementedError
'''

# Names that mean something else in a Ball.
RENAMED = {"hello": None, "effect.stop": "stop", "effect.stop_all": "stop_all", "events.subscribe": None,
           "events.unsubscribe": None, "telemetry.subscribe": None, "telemetry.unsubscribe": None}


def python_name(method):
    """pulse for effect.pulse, status for device.status, pattern_list for pattern.list; None: written by hand."""
    if method in RENAMED:
        return RENAMED[method]
    namespace, _, rest = method.partition(".")
    if not rest:
        return namespace
    return rest if namespace in ("effect", "device") else namespace + "_" + rest


def python_type(schema):
    if "enum" in schema:
        return "str"
    if "$ref" in schema:
        return "Direction" if schema["$ref"].endswith("/Direction") else "Any"
    kind = schema.get("type")
    if kind == "array":
        return "List[" + python_type(schema.get("items", {})) + "]"
    return {"number": "float", "integer": "int", "string": "str", "boolean": "bool", "object": "Mapping[str, Any]"}.get(
        kind, "Any")


def bounds(schema):
    if "enum" in schema:
        return ", ".join(str(value) for value in schema["enum"])
    low, high = schema.get("minimum"), schema.get("maximum")
    if low is not None and high is not None:
        return "%s to %s" % (low, high)
    if low is not None:
        return "at least %s" % low
    return ""


def parameter_line(parameter):
    schema = parameter["schema"]
    what = "; ".join(part for part in (schema.get("description", "").rstrip("."), bounds(schema)) if part)
    return "%s: %s" % (parameter["name"], what) if what else parameter["name"]


def method_text(method, asynchronous):
    name = python_name(method["name"])
    required = [p for p in method["params"] if p.get("required")]
    optional = [p for p in method["params"] if not p.get("required")]
    arguments = ["self"] + ["%s: %s" % (p["name"], python_type(p["schema"])) for p in required]
    # What a newcomer writes first may stand without its name.
    first = optional[:1] if not required and optional and optional[0]["name"] in ("direction", "axis", "pattern") else []
    arguments += ["%s: Optional[%s] = None" % (p["name"], python_type(p["schema"])) for p in first]
    rest = [p for p in optional if p not in first]
    if rest:
        arguments.append("*")
        arguments += ["%s: Optional[%s] = None" % (p["name"], python_type(p["schema"])) for p in rest]
    head = "    %sdef %s(" % ("async " if asynchronous else "", name)
    # A parameter is not torn from its type.
    together = [argument.replace(" ", "\0") for argument in arguments]
    together[-1] += ")\0->\0Any:"
    lines = [""] + [line.replace("\0", " ") for line in
                    textwrap.wrap(head + ", ".join(together), 112, subsequent_indent=" " * len(head))]
    documented = [parameter_line(p) for p in method["params"]]
    if documented:
        lines.append('        """%s' % method["summary"])
        lines.append("")
        for line in documented:
            lines += textwrap.wrap(line, 108, initial_indent=" " * 8, subsequent_indent=" " * 12)
        lines.append('        """')
    else:
        lines.append('        """%s"""' % method["summary"])
    names = [p["name"] for p in method["params"]]
    passed = "".join(", %s=%s" % (n, n) for n in names)
    call = "        return %sself.call(%s%s)" % ("await " if asynchronous else "", json.dumps(method["name"]), passed)
    lines += textwrap.wrap(call, 112, subsequent_indent=" " * 12)
    return "\n".join(lines) + "\n"


def module_text():
    methods = [m for m in json.loads(DOCUMENT.read_text(encoding="utf-8"))["methods"] if python_name(m["name"])]
    text = HEAD
    for name, doc, asynchronous in (("Methods", "Methods that wait for their response.", False),
                                    ("AsyncMethods", "The same as coroutines.", True)):
        text += CLASS.format(name=name, doc=doc, do="async " if asynchronous else "")
        text += "".join(method_text(m, asynchronous) for m in methods)
    return text


def main():
    text = module_text()
    if "--check" in sys.argv[1:]:
        return 0 if MODULE.is_file() and MODULE.read_text(encoding="utf-8") == text else 1
    MODULE.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
