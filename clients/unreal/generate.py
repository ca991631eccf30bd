#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the plugin's effects, events, status, errors and method names from the OpenRPC document.

generate.py [--check]: with --check nothing is written; exit 1 says that a file is not what the document gives.
"""

import json
import pathlib
import sys
import textwrap

import generate_messages
from generate_messages import HEAD, pascal

HERE = pathlib.Path(__file__).resolve().parent
DOCUMENT = HERE.parent.parent / "protocol" / "schema" / "openrpc.json"
MODULE = HERE / "Source" / "HedgehogHaptics"

# Methods with a structure of their own; what all share is in FHedgehogEffect.
STRUCTURES = {"effect.circle": "FHedgehogCircle", "effect.play": "FHedgehogPlay"}
EFFECTS = ["effect.circle", "effect.hold", "effect.play", "effect.pulse", "effect.vibrate"]
# What is pointed at is an argument of its own.
ARGUMENTS = ["direction", "axis", "pattern"]


def is_plain(schema):
    return "enum" in schema or schema.get("type") in ("number", "integer", "string", "boolean")


def enum_name(parameter):
    return "EHedgehog" + pascal(parameter["name"])


def member(parameter):
    name = pascal(parameter["name"])
    return "b" + name if parameter["schema"].get("type") == "boolean" else name


def declared(parameter):
    """The member's type and what says that it is not given."""
    schema = parameter["schema"]
    if "enum" in schema:
        return enum_name(parameter), enum_name(parameter) + "::Default"
    if schema["type"] == "boolean":
        return "bool", "false"
    if schema["type"] == "string":
        return "FString", None
    if schema["type"] == "integer":
        return ("int32" if schema.get("maximum", 1 << 40) < 1 << 31 else "int64"), "-1"
    return "float", "-1.0f"


def number(value):
    return "%g" % value


def enum_text(parameter):
    words = ["Default"] + [pascal(word) for word in parameter["schema"]["enum"]]
    return "UENUM(BlueprintType)\nenum class %s : uint8 { %s };\n" % (enum_name(parameter), ", ".join(words))


def property_text(parameter):
    schema = parameter["schema"]
    lines = []
    if schema.get("description"):
        lines += textwrap.wrap(schema["description"], 100, initial_indent="  /// ", subsequent_indent="  /// ")
    meta = ""
    if "minimum" in schema:
        bounds = ['ClampMin = "-1"']
        if "maximum" in schema:
            bounds.append('ClampMax = "%s"' % number(schema["maximum"]))
            lines.append("  /// %s to %s; -1: not given." % (number(schema["minimum"]), number(schema["maximum"])))
        else:
            lines.append("  /// At least %s; -1: not given." % number(schema["minimum"]))
        meta = ", meta = (%s)" % ", ".join(bounds)
    kind, nothing = declared(parameter)
    lines.append('  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog"%s)' % meta)
    lines.append("  %s %s%s;" % (kind, member(parameter), " = " + nothing if nothing else ""))
    return "\n".join(lines) + "\n"


def struct_text(name, base, about, parameters):
    text = "\n/// %s\nUSTRUCT(BlueprintType)\nstruct HEDGEHOGHAPTICS_API %s%s {\n  GENERATED_BODY()\n\n" % (
        about, name, " : public " + base if base else "")
    return text + "\n".join(property_text(p) for p in parameters) + "};\n"


def setter(parameter):
    schema, name = parameter["schema"], member(parameter)
    key = '"%s"' % parameter["name"]
    if "enum" in schema:
        words = ", ".join('"%s"' % word for word in schema["enum"])
        return ("  if (Effect.%s != %s::Default) {\n    static const char* const Words[] = {%s};\n"
                "    Given.set(%s, Words[static_cast<int>(Effect.%s) - 1]);\n  }\n" % (
                    name, enum_name(parameter), words, key, name))
    if schema["type"] == "boolean":
        return "  if (Effect.%s) Given.set(%s, true);\n" % (name, key)
    if schema["type"] == "string":
        return "  if (!Effect.%s.IsEmpty()) Given.set(%s, std::string(TCHAR_TO_UTF8(*Effect.%s)));\n" % (name, key, name)
    kind = declared(parameter)[0]
    value = "Decimal(Effect.%s)" % name if kind == "float" else "static_cast<std::int64_t>(Effect.%s)" % name
    return "  if (Effect.%s >= 0) Given.set(%s, %s);\n" % (name, key, value)


def by_structure(document):
    """What all effects share, and what the structures add."""
    methods = {m["name"]: [p for p in m["params"] if is_plain(p["schema"]) and p["name"] not in ARGUMENTS]
               for m in document["methods"] if m["name"] in EFFECTS}
    names = set.intersection(*({p["name"] for p in params} for params in methods.values()))
    shared = [p for p in methods["effect.pulse"] if p["name"] in names]
    return shared, {method: [p for p in methods[method] if p["name"] not in names] for method in STRUCTURES}


def effects_text(shared, added):
    text = HEAD + "// An effect's parameters; what is not given is left to the daemon. protocol/README.md has them at length.\n"
    text += '#pragma once\n\n#include "CoreMinimal.h"\n\n#include "hedgehog_effect.generated.h"\n\n'
    everything = shared + [p for parameters in added.values() for p in parameters]
    text += "\n".join(enum_text(p) for p in everything if "enum" in p["schema"])
    text += struct_text("FHedgehogEffect", None, "What every effect has.", shared)
    for method, parameters in added.items():
        text += struct_text(STRUCTURES[method], "FHedgehogEffect", "For %s." % method, parameters)
    return text


def json_header_text(added):
    text = HEAD + '#pragma once\n\n#include "core/json.h"\n#include "hedgehog_effect.h"\n\n'
    return text + "".join("/// What is given of it, as the protocol has it.\nhedgehog::unreal::Json HedgehogToJson(const %s& Effect);\n" % name
                          for name in ["FHedgehogEffect"] + [STRUCTURES[m] for m in added])


def json_source_text(shared, added):
    text = HEAD + '#include "hedgehog_effect_json.h"\n\n#include <cmath>\n\nusing hedgehog::unreal::Json;\n\nnamespace {\n\n'
    text += "/// 0.1f as 0.1, not as 0.100000001490116.\ndouble Decimal(float Value) { return std::round(static_cast<double>(Value) * 1e6) / 1e6; }\n\n"
    text += "}  // namespace\n"
    for name, parameters, start in [("FHedgehogEffect", shared, "Json::object()")] + [
            (STRUCTURES[m], added[m], "HedgehogToJson(static_cast<const FHedgehogEffect&>(Effect))") for m in added]:
        text += "\nJson HedgehogToJson(const %s& Effect) {\n  Json Given = %s;\n" % (name, start)
        text += "".join(setter(p) for p in parameters) + "  return Given;\n}\n"
    return text


def methods_text(document):
    text = HEAD + "// What the daemon understands and tells.\n#pragma once\n\nnamespace hedgehog::unreal::methods {\n\n"
    text += "".join('inline constexpr const char* k%s = "%s";\n' % (pascal(m["name"]), m["name"]) for m in document["methods"])
    events = document["components"]["schemas"]["Event"]["properties"]["type"]["examples"]
    text += "\n/// The types of events.\ninline constexpr const char* kEvents[] = {\n"
    text += "".join('    "%s",\n' % event for event in events)
    return text + "};\n\n}  // namespace hedgehog::unreal::methods\n"


def error_text(errors):
    text = HEAD + "// Why the daemon refuses a request.\n"
    text += '#pragma once\n\n#include "CoreMinimal.h"\n\n#include "hedgehog_error.generated.h"\n\n'
    text += "UENUM(BlueprintType)\nenum class EHedgehogError : uint8 {\n  None,\n"
    text += "".join("  /// %s\n  %s,\n" % (error["message"], pascal(name)) for name, error in errors.items())
    text += "  /// One that a later daemon has.\n  Other,\n};\n\n/// Of an answer's Code; 0: None.\n"
    text += "inline EHedgehogError HedgehogErrorOf(int32 Code) {\n  switch (Code) {\n    case 0: return EHedgehogError::None;\n"
    text += "".join("    case %d: return EHedgehogError::%s;\n" % (error["code"], pascal(name)) for name, error in errors.items())
    return text + "    default: return EHedgehogError::Other;\n  }\n}\n"


def files():
    document = json.loads(DOCUMENT.read_text(encoding="utf-8"))
    shared, added = by_structure(document)
    return {MODULE / "Public" / "hedgehog_effect.h": effects_text(shared, added),
            MODULE / "Public" / "hedgehog_error.h": error_text(document["components"]["errors"]),
            MODULE / "Private" / "hedgehog_effect_json.h": json_header_text(added),
            MODULE / "Private" / "hedgehog_effect_json.cpp": json_source_text(shared, added),
            MODULE / "Private" / "core" / "methods.h": methods_text(document),
            **generate_messages.files(document, MODULE / "Public", MODULE / "Private")}


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
