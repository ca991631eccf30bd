#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes addons/hedgehog/methods.gd and fields.gd from the OpenRPC document.

generate.py [--check]: with --check nothing is written; exit 1 says that a file is not what the document gives.
"""

import json
import pathlib
import sys
import textwrap

HERE = pathlib.Path(__file__).resolve().parent
DOCUMENT = HERE.parent.parent / "protocol" / "schema" / "openrpc.json"
ADDON = HERE / "addons" / "hedgehog"

HEAD = '''\
# SPDX-License-Identifier: MIT
# Written by generate.py from protocol/schema/openrpc.json.
# The daemon's methods. What is pointed at comes first, the other parameters by name; protocol/README.md has them at length.
# A direction is "left", [0, 1, 0], Vector3(-1, 0, 0), {"azimuth_deg": 90} or {"pin": 34}: where the pins push out.
extends Node

'''

TAIL = '''

## Overridden: sends, and returns the request.
func request(_method: String, _params: Dictionary = {}):
	return null


## Why the daemon will refuse these parameters, as far as names and ranges tell; empty: they do not.
func problem_of(method: String, params: Dictionary) -> String:
	var known = PARAMETERS.get(method)
	if known == null:
		return "there is no such method"
	for key in params:
		if not known.has(key):
			return "there is no parameter '%s'" % key
		var value = params[key]
		var allowed = known[key]
		if allowed == null or value == null:
			continue
		if typeof(allowed[0]) == TYPE_STRING:
			if not value in allowed:
				return "%s: is none of %s" % [key, allowed]
		elif not (typeof(value) == TYPE_INT or typeof(value) == typeof(0.5)):
			return "%s: is no number" % key
		elif value < allowed[0]:
			return "%s: is below %s" % [key, allowed[0]]
		elif allowed.size() > 1 and value > allowed[1]:
			return "%s: is above %s" % [key, allowed[1]]
	return ""


func _with(params: Dictionary, key: String, value) -> Dictionary:
	var all = params.duplicate()
	all[key] = value
	return all
'''

FIELDS_HEAD = '''\
# SPDX-License-Identifier: MIT
# Written by generate.py from protocol/schema/openrpc.json.
# The names of the fields of an event and of a status, with their types; the editor completes them. Telemetry has those fields of the
# status that were asked for.
#
#   status[Ball.Fields.Status.TEMPERATURE_C][Ball.Fields.StatusTemperatureC.MODEL]
'''

# What `event_received` and `telemetry_received` have.
MESSAGES = ["Event", "Status"]

# Written by hand in ball.gd.
OWN = ["hello", "events.subscribe", "events.unsubscribe", "telemetry.subscribe", "telemetry.unsubscribe"]
# What a newcomer writes first may stand without its name.
FIRST = ["direction", "axis", "pattern"]


def name_of(method):
    """pulse for effect.pulse, status for device.status, pattern_list for pattern.list."""
    namespace, _, rest = method.partition(".")
    if not rest:
        return namespace
    return rest if namespace in ("effect", "device") else namespace + "_" + rest


def allowed(schema):
    """What PARAMETERS has: the words, [minimum] or [minimum, maximum], or null."""
    if "enum" in schema:
        return json.dumps(schema["enum"])
    if "minimum" not in schema:
        return "null"
    return json.dumps([schema[key] for key in ("minimum", "maximum") if key in schema])


def bounds(schema):
    if "enum" in schema:
        return ", ".join(str(value) for value in schema["enum"])
    if "minimum" not in schema:
        return ""
    if "maximum" not in schema:
        return "at least %s" % schema["minimum"]
    return "%s to %s" % (schema["minimum"], schema["maximum"])


def parameter_line(parameter):
    schema = parameter["schema"]
    what = "; ".join(part for part in (schema.get("description", "").rstrip("."), bounds(schema)) if part)
    return "%s: %s" % (parameter["name"], what) if what else parameter["name"]


def wrapped(text, first, following):
    return textwrap.wrap(text, 124, initial_indent=first, subsequent_indent=following, break_long_words=False)


def parameters_text(methods):
    lines = ["## By method and parameter: [minimum, maximum], [minimum], the words that are allowed, or null.",
             "const PARAMETERS = {"]
    for method in methods:
        # A parameter is not torn from its range.
        fields = ", ".join('"%s": %s' % (p["name"], allowed(p["schema"])) for p in method["params"])
        torn = fields.replace("], ", "]\1").replace("null, ", "null\1").replace(" ", "\0").replace("\1", ", ")
        lines += [line.replace("\0", " ") for line in
                  wrapped('"%s":\0{%s},' % (method["name"], torn), "\t", "\t\t")]
    return "\n".join(lines + ["}"]) + "\n"


def errors_text(errors):
    lines = ["## Codes of refusals by name: a request's `code` and `error_name`.", "const ERROR_CODES = {"]
    return "\n".join(lines + ['\t"%s": %d,' % (name, error["code"]) for name, error in errors.items()] + ["}"]) + "\n"


def method_text(method):
    first = method["params"][0] if method["params"] and method["params"][0]["name"] in FIRST else None
    lines = ["", "", "## " + method["summary"]]
    for parameter in method["params"]:
        lines += wrapped(parameter_line(parameter), "## ", "##     ")
    arguments, passed = "params: Dictionary = {}", "params"
    if first:
        arguments = first["name"] + ("" if first.get("required") else " = null") + ", " + arguments
        passed = '_with(params, "%s", %s)' % (first["name"], first["name"])
    lines.append("func %s(%s):" % (name_of(method["name"]), arguments))
    lines.append('\treturn request("%s", %s)' % (method["name"], passed))
    return "\n".join(lines) + "\n"


def script_text():
    document = json.loads(DOCUMENT.read_text(encoding="utf-8"))
    events = document["components"]["schemas"]["Event"]["properties"]["type"]["examples"]
    text = HEAD + "\n".join(["## The types of events."] + wrapped("const EVENTS = [%s]" % json.dumps(events)[1:-1], "", "\t")) + "\n\n"
    text += errors_text(document["components"]["errors"]) + "\n"
    text += parameters_text(document["methods"])
    text += "".join(method_text(m) for m in document["methods"] if m["name"] not in OWN)
    return text + TAIL


class Fields:
    """A class of constants for each shape of object in the messages, in the order in which they are named."""

    def __init__(self):
        self._by_shape = {}
        self.texts = []

    def add(self, name, schema):
        """The class's name."""
        shape = repr(schema)
        if shape not in self._by_shape:
            self._by_shape[shape] = name
            lines = [self._line(name, key, value, key in schema.get("required", [])) for key, value in schema["properties"].items()]
            self.texts.append("\n\nclass %s:\n%s" % (name, "".join(lines)))
        return self._by_shape[shape]

    def _line(self, name, key, schema, required):
        what = self._what(name + pascal(key), schema) + ("" if required else "; optional")
        return '\tconst %s = "%s"  ## %s\n' % (key.upper(), key, what)

    def _what(self, name, schema):
        if "anyOf" in schema:
            return " or ".join(self._what(name, one) for one in schema["anyOf"])
        kind = schema["type"]
        if kind == "object":
            return self.add(name, schema)
        if kind == "array":
            # One of the effects is an effect.
            items = self._what(name[:-1], schema["items"])
            several = {"number": "numbers", "text": "texts"}.get(items, items)
            return "array of %s%s" % ("3 " if schema.get("maxItems") == 3 else "", several)
        return {"string": "text"}.get(kind, kind)


def pascal(words):
    return "".join(part.capitalize() for part in words.split("_"))


def fields_text():
    schemas = json.loads(DOCUMENT.read_text(encoding="utf-8"))["components"]["schemas"]
    fields = Fields()
    for name in MESSAGES:
        fields.add(name, schemas[name])
    return FIELDS_HEAD + "".join(fields.texts)


def main():
    stale = False
    for path, text in {ADDON / "methods.gd": script_text(), ADDON / "fields.gd": fields_text()}.items():
        if "--check" not in sys.argv[1:]:
            path.write_text(text, encoding="utf-8")
        elif not path.is_file() or path.read_text(encoding="utf-8") != text:
            stale = True
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
