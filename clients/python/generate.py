#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes hedgehog/methods.py, messages.py and error_codes.py from the OpenRPC document.

generate.py [--check]: with --check nothing is written; exit 1 says that a file is not what the document gives.
"""

import json
import pathlib
import re
import sys
import textwrap

HERE = pathlib.Path(__file__).resolve().parent
DOCUMENT = HERE.parent.parent / "protocol" / "schema" / "openrpc.json"
PACKAGE = HERE / "hedgehog"

HEAD = "# SPDX-License-Identifier: MIT\n# Written by generate.py from protocol/schema/openrpc.json.\n"
WIDTH = 112

METHODS_DOC = '''\
"""The daemon's methods. Parameters that are None are left out; protocol/README.md has all of them at length."""

from typing import Any, Mapping, Optional, Sequence

from .messages import ('''

CLASS = '''

class {name}:
    """{doc}"""

    {do}def call(self, method: str, /, **params: Any) -> Any:
        raise NotImplementedError
'''

# Names that mean something else in a Ball.
RENAMED = {"hello": None, "effect.stop": "stop", "effect.stop_all": "stop_all", "events.subscribe": None,
           "events.unsubscribe": None, "telemetry.subscribe": None, "telemetry.unsubscribe": None}

# What an alternative of a direction is, by its first key.
ALTERNATIVES = {"pin": "Pin", "azimuth_deg": "Angles"}


def python_name(method):
    """pulse for effect.pulse, status for device.status, pattern_list for pattern.list; None: written by hand."""
    if method in RENAMED:
        return RENAMED[method]
    namespace, _, rest = method.partition(".")
    if not rest:
        return namespace
    return rest if namespace in ("effect", "device") else namespace + "_" + rest


def pascal(words):
    return "".join(word[:1].upper() + word[1:] for word in re.split(r"[_.]", words))


def literal(values):
    return "Literal[%s]" % ", ".join(json.dumps(value) for value in values)


def wrapped(text, indent):
    """In lines; a word in quotes is not torn apart."""
    return "\n".join(textwrap.wrap(text, WIDTH, subsequent_indent=" " * indent, break_long_words=False))


class Messages:
    """Types of what is sent and received: enumerations, and a TypedDict for each shape of object in the document."""

    def __init__(self, document):
        self.schemas = document["components"]["schemas"]
        self.names = {}
        self.definitions = []
        self.defined = set()
        self.alias("TelemetryField", self.schemas["TelemetrySubscription"]["properties"]["fields"]["items"]["enum"])
        # Those of the document first: what they share with a parameter has their names.
        for name, schema in self.schemas.items():
            if name == "Error":
                continue
            kind = self.type_of(schema, name)
            if kind != name:
                self.defined.add(name)
                self.definitions.append("\n%s = %s\n" % (name, kind))
        self.type_of(self.schemas["Error"]["properties"]["data"], "ErrorData")
        self.alias("EventType", self.schemas["Event"]["properties"]["type"]["examples"])
        for method in document["methods"]:
            for parameter in method["params"]:
                self.type_of(parameter["schema"], pascal(parameter["name"]))

    def alias(self, name, values):
        shape = json.dumps(values)
        if shape not in self.names:
            # Another enumeration of that name: of the message that has it.
            assert name not in self.defined, "two enumerations " + name
            self.names[shape] = name
            self.defined.add(name)
            self.definitions.append("\n" + wrapped("%s = %s" % (name, literal(values)), len(name) + 11) + "\n")
        return self.names[shape]

    def type_of(self, schema, name):
        """Of a field or parameter; `name` is that of a type which is not known yet."""
        if "$ref" in schema:
            return schema["$ref"].rpartition("/")[2]
        if "anyOf" in schema:
            return self.union(schema, name)
        if "enum" in schema:
            return self.alias(name, schema["enum"])
        if schema.get("type") == "array":
            return "Sequence[%s]" % self.type_of(schema.get("items", {}), name + "Item")
        if schema.get("type") == "object" and "properties" in schema:
            return self.record(schema, name)
        return {"number": "float", "integer": "int", "string": "str", "boolean": "bool", "null": "None",
                "object": "Mapping[str, Any]"}.get(schema.get("type"), "Any")

    def union(self, schema, name):
        others = [one for one in schema["anyOf"] if one.get("type") != "null"]
        if len(others) == 1:
            return "Optional[%s]" % self.type_of(others[0], name)
        kinds = [self.type_of(one, name + ALTERNATIVES.get(next(iter(one.get("properties", {})), None), "Name"))
                 for one in others]
        text = "\n%s = Union[%s]\n" % (name, ", ".join(kinds))
        if schema.get("title") == "Direction":
            text = '\n#: "left", [0, 1, 0], {"azimuth_deg": 90} or {"pin": 34}: where the pins push out.' + text
        self.definitions.append(text)
        return name

    def record(self, schema, name):
        required = schema.get("required", [])
        shape = json.dumps([schema["properties"], required], sort_keys=True)
        if shape in self.names and name not in self.schemas:
            return self.names[shape]
        # Items of "effects" are one StatusEffects each.
        name = name[:-4] if name.endswith("Item") else name
        while name in self.defined:
            name += "Object"
        self.names.setdefault(shape, name)
        self.defined.add(name)
        fields = {key: self.type_of(one, name + pascal(key)) for key, one in schema["properties"].items()}
        lines = {True: [], False: []}
        for key, kind in fields.items():
            lines[key in required].append("    %s: %s\n" % (key, kind))
        # What may be missing is in a class of its own: typing has NotRequired from Python 3.11 on.
        text = ""
        base = "TypedDict"
        if lines[True] and lines[False]:
            base = "_%sAlways" % name
            text += "\n\nclass %s(TypedDict):\n%s" % (base, "".join(lines[True]))
        what = '    """%s of protocol/README.md."""\n\n' % name if name in self.schemas else ""
        members = "".join(lines[False] or lines[True]) or "    pass\n"
        text += "\n\nclass %s(%s%s):\n%s%s" % (name, base, ", total=False" if lines[False] else "", what, members)
        self.definitions.append(text + "\n\n")
        return name

    def text(self):
        definitions = re.sub(r"\n{4,}", "\n\n\n", "".join(self.definitions)).rstrip("\n") + "\n"
        return (HEAD + '"""Types of what the daemon receives and sends. A later daemon may send more."""\n\n'
                "from typing import Any, Literal, Mapping, Optional, Sequence, TypedDict, Union\n" + definitions)


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


class MethodsModule:
    """methods.py."""

    def __init__(self, document, messages):
        self.methods = [m for m in document["methods"] if python_name(m["name"])]
        self.messages = messages
        self.used = set()

    def type_of(self, schema, name):
        kind = self.messages.type_of(schema, name)
        self.used |= set(re.findall(r"\w+", kind)) & (self.messages.defined | {"Direction"})
        return kind

    def parameter(self, parameter):
        return "%s: %s" % (parameter["name"], self.type_of(parameter["schema"], pascal(parameter["name"])))

    def optional(self, parameter):
        return "%s: Optional[%s] = None" % (parameter["name"], self.type_of(parameter["schema"], pascal(parameter["name"])))

    def method(self, method, asynchronous):
        required = [p for p in method["params"] if p.get("required")]
        optional = [p for p in method["params"] if not p.get("required")]
        arguments = ["self"] + [self.parameter(p) for p in required]
        # What a newcomer writes first may stand without its name.
        first = optional[:1] if not required and optional and optional[0]["name"] in ("direction", "axis", "pattern") else []
        arguments += [self.optional(p) for p in first]
        rest = [p for p in optional if p not in first]
        if rest:
            arguments.append("*")
            arguments += [self.optional(p) for p in rest]
        head = "    %sdef %s(" % ("async " if asynchronous else "", python_name(method["name"]))
        result = self.type_of(method["result"]["schema"], "")
        # A parameter is not torn from its type.
        together = [argument.replace(" ", "\0") for argument in arguments]
        together[-1] += ")\0->\0%s:" % result
        lines = [""] + [line.replace("\0", " ") for line in
                        textwrap.wrap(head + ", ".join(together), WIDTH, subsequent_indent=" " * len(head))]
        documented = [parameter_line(p) for p in method["params"]]
        if documented:
            lines.append('        """%s' % method["summary"])
            lines.append("")
            for line in documented:
                lines += textwrap.wrap(line, 108, initial_indent=" " * 8, subsequent_indent=" " * 12)
            lines.append('        """')
        else:
            lines.append('        """%s"""' % method["summary"])
        passed = "".join(", %s=%s" % (p["name"], p["name"]) for p in method["params"])
        call = "        result: %s = %sself.call(%s%s)" % (result, "await " if asynchronous else "", json.dumps(method["name"]), passed)
        lines += textwrap.wrap(call, WIDTH, subsequent_indent=" " * 12)
        lines.append("        return result")
        return "\n".join(lines) + "\n"

    def text(self):
        text = ""
        for name, doc, asynchronous in (("Methods", "Methods that wait for their response.", False),
                                        ("AsyncMethods", "The same as coroutines.", True)):
            text += CLASS.format(name=name, doc=doc, do="async " if asynchronous else "")
            text += "".join(self.method(m, asynchronous) for m in self.methods)
        names = "\n".join(textwrap.wrap(", ".join(sorted(self.used)), WIDTH - 4, initial_indent="    ", subsequent_indent="    "))
        return HEAD + METHODS_DOC + "\n" + names + ",\n)\n" + text


def error_codes_text(errors):
    text = HEAD + '"""Errors of the daemon, by name."""\n\nimport enum\nfrom typing import Literal\n'
    text += "\n" + wrapped("ErrorName = " + literal(errors), 20) + "\n\n\n"
    text += 'class ErrorCode(enum.IntEnum):\n    """Codes of RequestError."""\n\n'
    return text + "".join("    #: %s\n    %s = %d\n" % (one["message"], name.upper(), one["code"]) for name, one in errors.items())


def files():
    document = json.loads(DOCUMENT.read_text(encoding="utf-8"))
    messages = Messages(document)
    return {PACKAGE / "methods.py": MethodsModule(document, messages).text(), PACKAGE / "messages.py": messages.text(),
            PACKAGE / "error_codes.py": error_codes_text(document["components"]["errors"])}


def main():
    check = "--check" in sys.argv[1:]
    stale = False
    for path, text in files().items():
        if not check:
            path.write_text(text, encoding="utf-8")
        elif not path.is_file() or path.read_text(encoding="utf-8") != text:
            stale = True
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
