#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes Runtime/Core/Generated/*.cs from the OpenRPC document, and the .meta files that Unity wants beside every file.

generate.py [--check]: with --check nothing is written; exit 1 names each file that is not what the document gives.
"""

import hashlib
import json
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
PROTOCOL = HERE.parent.parent / "protocol"
GENERATED = pathlib.PurePosixPath("Runtime/Core/Generated")

HEAD = "// SPDX-License-Identifier: MIT\n// Written by generate.py from protocol/schema/openrpc.json.\n"
# Written by hand in AsyncBall.
OWN = ("hello",)
# Lists of objects whose fields have no class: a Params each.
OBJECTS = ("keyframes", "errors")


def pascal(words):
    return "".join(word[:1].upper() + word[1:] for word in re.split(r"[_.\s-]", words))


def camel(words):
    name = pascal(words)
    return name[:1].lower() + name[1:]


def argument(name):
    return {"params": "@params"}.get(camel(name), camel(name))


def method_name(method):
    """Pulse for effect.pulse, Status for device.status, PatternList for pattern.list."""
    namespace, _, rest = method.partition(".")
    return pascal(rest if rest and namespace in ("effect", "device") else method)


def constants(values):
    """EffectPulse for effect.pulse, and so on."""
    return [(pascal(value), value) for value in values]


class Types:
    """Classes of results, one for each shape of object in the document."""

    def __init__(self, schemas):
        self.schemas = schemas
        self.classes = {}
        self.texts = []
        for name in schemas:
            if name != "Direction":
                self.add(name, schemas[name])

    def add(self, name, schema):
        shape = json.dumps(schema.get("properties", {}), sort_keys=True) + str(schema.get("required", []))
        if shape in self.classes and name not in self.schemas:
            return self.classes[shape]
        self.classes.setdefault(shape, name)
        self.texts.append(None)
        place = len(self.texts) - 1
        fields = "".join(self.field(name, key, value, key in schema.get("required", []))
                         for key, value in schema.get("properties", {}).items())
        self.texts[place] = '''
    /// <summary>%s of protocol/README.md.</summary>
    public sealed class %s
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public %s(Json json)
        {
            Json = json;
        }
%s    }
''' % (name, name, name, fields)
        return name

    def field(self, owner, key, schema, required):
        if "anyOf" in schema:
            others = [one for one in schema["anyOf"] if one.get("type") != "null"]
            required = required and len(others) == len(schema["anyOf"])
            schema = others[0] if len(others) == 1 else {}
        kind, value = self.read(owner + pascal(key), schema, 'Json["%s"]' % key)
        if kind in ("double", "long", "bool") and not required:
            kind, value = kind + "?", '%s ? (%s?)null : %s' % ('Json["%s"].IsNull' % key, kind, value)
        elif kind not in ("double", "long", "bool", "string", "Json"):
            value = '%s ? null : %s' % ('Json["%s"].IsNull' % key, value)
        name = pascal(key)
        return '''
        public %s %s
        {
            get { return %s; }
        }
''' % (kind, name + "Value" if name == owner else name, value)

    def read(self, name, schema, place):
        """The C# type of a field, and the expression that takes it from the Json `place`."""
        if "enum" in schema or schema.get("type") == "string":
            return "string", place + ".Text"
        simple = {"number": ("double", ".Number"), "integer": ("long", ".Integer"), "boolean": ("bool", ".Flag")}
        if schema.get("type") in simple:
            kind, member = simple[schema["type"]]
            return kind, place + member
        if schema.get("type") == "array":
            items = schema.get("items", {})
            if items.get("type") in ("number", "integer"):
                return "double[]", "Read.Numbers(%s)" % place
            if items.get("type") == "string" or "enum" in items:
                return "string[]", "Read.Texts(%s)" % place
            if items.get("type") == "object" and "properties" in items:
                kind = self.add(name, items)
                return kind + "[]", "Read.List(%s, one => new %s(one))" % (place, kind)
        if schema.get("type") == "object" and "properties" in schema:
            kind = self.add(name, schema)
            return kind, "new %s(%s)" % (kind, place)
        return "Json", place

    def text(self):
        return HEAD + "\nnamespace Hedgehog.Results\n{" + "".join(self.texts)[0:] + "}\n"


class Requests:
    """Enumerations, ranges and methods of the requests."""

    def __init__(self, methods, errors):
        self.methods = [method for method in methods if method["name"] not in OWN]
        self.errors = errors
        self.enums = {}
        self.ranges = {}
        for method in self.methods:
            for parameter in method["params"]:
                self.learn(parameter["name"], parameter["schema"])

    def learn(self, name, schema):
        if "enum" in schema:
            known = self.enums.setdefault(pascal(name), schema["enum"])
            assert known == schema["enum"], "two enumerations " + name
        low, high = schema.get("minimum"), schema.get("maximum")
        for key, value in (("Min", low), ("Max", high)):
            if value is not None:
                known = self.ranges.setdefault(pascal(name) + key, value)
                assert known == value, "two ranges of " + name

    @staticmethod
    def type_of(name, schema):
        if "enum" in schema:
            return pascal(name)
        if schema.get("$ref", "").endswith("/Direction"):
            return "Direction"
        if schema.get("type") == "array":
            return "Params[]" if name in OBJECTS else "string[]"
        return {"number": "double", "integer": "long", "boolean": "bool", "string": "string", "object": "Params"}[schema["type"]]

    def words_text(self):
        text = HEAD + "\nnamespace Hedgehog\n{"
        for name, values in self.enums.items():
            text += "\n    public enum %s\n    {\n%s\n    }\n" % (
                name, ",\n".join("        " + word for word, _ in constants(values)))
        text += "\n    /// <summary>The words of the protocol for the enumerations.</summary>\n    internal static class Words\n    {"
        for name, values in self.enums.items():
            cases = "".join("                case %s.%s: return \"%s\";\n" % (name, word, value)
                            for word, value in constants(values))
            text += '''
        public static string Of(%s? value)
        {
            if (!value.HasValue) return null;
            switch (value.Value)
            {
%s                default: return null;
            }
        }
''' % (name, cases)
        text += "    }\n\n    /// <summary>What the parameters may be, for checks and for inspectors.</summary>\n"
        text += "    public static class Ranges\n    {\n"
        text += "".join("        public const double %s = %s;\n" % item for item in self.ranges.items())
        text += "    }\n\n    /// <summary>Codes of RequestError.</summary>\n    public static class ErrorCode\n    {\n"
        text += "".join("        public const int %s = %s;\n" % (pascal(name), error["code"]) for name, error in self.errors.items())
        text += "    }\n\n    /// <summary>Names of RequestError.</summary>\n    public static class ErrorName\n    {\n"
        text += "".join("        public const string %s = \"%s\";\n" % (pascal(name), name) for name in self.errors) + "    }\n}\n"
        return text

    def arguments(self, method):
        required = [p for p in method["params"] if p.get("required")]
        optional = [p for p in method["params"] if not p.get("required")]
        listed = ["%s %s" % (self.type_of(p["name"], p["schema"]), argument(p["name"])) for p in required]
        for p in optional:
            kind = self.type_of(p["name"], p["schema"])
            nullable = kind in ("double", "long", "bool") or kind in self.enums
            listed.append("%s%s %s = null" % (kind, "?" if nullable else "", argument(p["name"])))
        return listed

    def request(self, method):
        sets = ""
        for p in method["params"]:
            value = argument(p["name"])
            sets += '\n                .Set("%s", %s)' % (p["name"], "Words.Of(%s)" % value if "enum" in p["schema"] else value)
        return '"%s"' % method["name"] + (", new Params()" + sets if sets else "")

    def documentation(self, method):
        lines = "        /// <summary>%s</summary>\n" % escaped(method["summary"])
        for p in method["params"]:
            schema = p["schema"]
            what = [schema.get("description", "").rstrip(".")]
            if "minimum" in schema and "maximum" in schema:
                what.append("%s to %s" % (schema["minimum"], schema["maximum"]))
            elif "minimum" in schema:
                what.append("at least %s" % schema["minimum"])
            what = "; ".join(part for part in what if part)
            lines += '        /// <param name="%s">%s</param>\n' % (camel(p["name"]), escaped(what) or "See protocol/README.md")
        return lines

    def methods_text(self):
        text = HEAD + "\nusing System.Threading.Tasks;\n\nnamespace Hedgehog\n{"
        for name, doc, returned, before, after, override in (
                ("BlockingMethods", "Methods that wait for their response.", "{0}", "return new {0}(Call(", "));", "Json"),
                ("AsyncMethods", "The same as tasks.", "async Task<{0}>", "return new {0}(await Call(", ").ConfigureAwait(false));",
                 "Task<Json>")):
            text += "\n    /// <summary>%s Parameters that are null are not sent.</summary>\n" % doc
            text += "    public abstract class %s\n    {\n        public abstract %s Call(string method, Params parameters = null);\n" % (
                name, override)
            for method in self.methods:
                result = "Results." + method["result"]["schema"]["$ref"].rpartition("/")[2]
                text += "\n%s        public %s %s(%s)\n        {\n            %s%s%s\n        }\n" % (
                    self.documentation(method), returned.format(result), method_name(method["name"]),
                    ", ".join(self.arguments(method)), before.format(result), self.request(method), after)
            text += "    }\n"
        return text + "}\n"


def escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def guid(path):
    """The same wherever the package is, so that a scene finds its script again."""
    return hashlib.md5(("com.hedgehog.client/" + path).encode("utf-8")).hexdigest()


def meta_text(path, folder):
    head = "fileFormatVersion: 2\nguid: %s\n" % guid(path)
    if folder:
        return head + "folderAsset: yes\nDefaultImporter:\n  externalObjects: {}\n  userData:\n"
    importer = {".cs": "MonoImporter:\n  externalObjects: {}\n  serializedVersion: 2\n  defaultReferences: []\n"
                       "  executionOrder: 0\n  icon: {instanceID: 0}\n",
                ".asmdef": "AssemblyDefinitionImporter:\n  externalObjects: {}\n",
                ".json": "PackageManifestImporter:\n  externalObjects: {}\n",
                ".md": "TextScriptImporter:\n  externalObjects: {}\n"}
    return head + importer.get(pathlib.PurePosixPath(path).suffix, "DefaultImporter:\n  externalObjects: {}\n") + "  userData:\n"


def files():
    document = json.loads((PROTOCOL / "schema" / "openrpc.json").read_text(encoding="utf-8"))
    requests = Requests(document["methods"], document["components"]["errors"])
    written = {str(GENERATED / "Results.cs"): Types(document["components"]["schemas"]).text(),
               str(GENERATED / "Words.cs"): requests.words_text(),
               str(GENERATED / "Methods.cs"): requests.methods_text()}
    # Unity looks into no folder whose name ends with ~.
    assets = {path.relative_to(HERE).as_posix() for path in HERE.rglob("*") if path.suffix not in (".meta", ".pyc")}
    assets |= set(written) | {str(GENERATED)}
    for path in sorted(assets):
        if not any(part.endswith("~") or part == "__pycache__" for part in path.split("/")):
            written[path + ".meta"] = meta_text(path, (HERE / path).is_dir() or path == str(GENERATED))
    return written


def main():
    wanted = files()
    if "--check" in sys.argv[1:]:
        wrong = [path for path, text in wanted.items()
                 if not (HERE / path).is_file() or (HERE / path).read_text(encoding="utf-8") != text]
        wrong += [path.relative_to(HERE).as_posix() for path in HERE.rglob("*.meta")
                  if path.relative_to(HERE).as_posix() not in wanted]
        for path in wrong:
            print("clients/unity/%s is not what generate.py writes" % path)
        return 1 if wrong else 0
    for path, text in wanted.items():
        (HERE / path).parent.mkdir(parents=True, exist_ok=True)
        (HERE / path).write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
