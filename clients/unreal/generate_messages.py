# SPDX-License-Identifier: MIT
"""The plugin's events and status, as structures of Unreal and the code that reads them, for generate.py."""

HEAD = "// SPDX-License-Identifier: MIT\n// Written by generate.py from protocol/schema/openrpc.json.\n// clang-format off\n"
PROPERTY = '  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")\n'
MESSAGES = {"Event": "An event: an effect has started or ended, the state has changed.", "Status": "The status of the ball."}

# Lists of three numbers that are vectors of the ball: directions, and rates about its axes.
DIRECTIONS = ("field", "up")
RATES = ("rate_deg_s",)
VECTORS = DIRECTIONS + RATES
# An object that Unreal has a type for.
QUATERNION = "quaternion"

NOTES = '''\
// Optional members have a bHas... beside them; an optional text or list that was not sent is empty. Vectors and quaternions are in
// Unreal's axes: x forward, y right, z up. Json has all fields, also those that are newer than this version.
'''
PLAIN = {"integer": ("int64", "0"), "number": ("float", "0.0f"), "boolean": ("bool", "false")}

HELPERS = '''
namespace hedgehog::unreal {

static void Read(const Json& Value, bool& Member) { Member = Value.truth(); }
static void Read(const Json& Value, int64& Member) { Member = static_cast<int64>(Value.number()); }
static void Read(const Json& Value, float& Member) { Member = static_cast<float>(Value.number()); }
static void Read(const Json& Value, FString& Member) { Member = FString(UTF8_TO_TCHAR(Value.text().c_str())); }

/// The ball's axes are x front, y left, z up: Unreal's, with y reversed.
static FVector ToDirection(const Json& Value) {
  if (Value.items().size() != 3) return FVector::ZeroVector;
  return FVector(Value.items()[0].number(), -Value.items()[1].number(), Value.items()[2].number());
}

/// A rotation changes its sense when an axis is reversed.
static FVector ToRate(const Json& Value) { return -ToDirection(Value); }

static void Read(const Json& Value, FQuat& Member) {
  if (!Value.is(Json::Kind::kObject)) return;
  Member = FQuat(-Value["x"].number(), Value["y"].number(), -Value["z"].number(), Value["w"].number());
}

static void Read(const Json& Value, EHedgehogEventType& Member) {
  std::uint8_t Number = 0;
  Member = EHedgehogEventType::Other;
  for (const char* Type : methods::kEvents) {
    ++Number;
    if (Value.text() == Type) Member = static_cast<EHedgehogEventType>(Number);
  }
}
'''
LIST = '''
template <class T>
static void Read(const Json& Value, TArray<T>& Member) {
  for (const Json& One : Value.items()) {
    T Item{};
    Read(One, Item);
    Member.Add(Item);
  }
}
'''


def pascal(words):
    return "".join(part.capitalize() for part in words.replace(".", "_").split("_"))


class Structures:
    """One for each shape of object in the messages, in the order in which they need each other."""

    def __init__(self):
        self._by_shape = {}
        self.declared = {}
        self.readers = []

    def add(self, owner, name, schema):
        """The structure's name; `owner` is the message that declares it first."""
        shape = repr(schema)
        if shape in self._by_shape:
            return self._by_shape[shape]
        self._by_shape[shape] = "FHedgehog" + name
        required = schema.get("required", [])
        members, reads = "", ""
        for key, value in schema["properties"].items():
            text, read = self._member(owner, name, key, value, key in required)
            members += text
            reads += read
        about = ""
        if name == owner:
            about = "/// %s\n" % MESSAGES[name]
            members += "  /// The whole message.\n" + PROPERTY + "  FString Json;\n"
            reads += "  Message.Json = FString(UTF8_TO_TCHAR(Value.to_text().c_str()));\n"
        self.declared.setdefault(owner, []).append(
            "\n%sUSTRUCT(BlueprintType)\nstruct HEDGEHOGHAPTICS_API FHedgehog%s {\n  GENERATED_BODY()\n\n%s};\n" % (about, name, members))
        self.readers.append((name, reads))
        return self._by_shape[shape]

    def _member(self, owner, name, key, schema, required):
        if "anyOf" in schema:
            others = [one for one in schema["anyOf"] if one.get("type") != "null"]
            assert len(others) == 1, key
            required = required and len(others) == len(schema["anyOf"])
            schema = others[0]
        if name == "Event" and key == "type":
            return self._type_member()
        kind, start = self._kind(owner, name, key, schema)
        place = 'Value["%s"]' % key
        member = ("b" if kind == "bool" else "") + pascal(key)
        text, read = "", ""
        if not required and start is not None:
            flag = "bHas" + pascal(key)
            text += "%s  bool %s = false;\n" % (PROPERTY, flag)
            read += "  Message.%s = !%s.is(Json::Kind::kNull);\n" % (flag, place)
        text += "%s  %s %s%s;\n" % (PROPERTY, kind, member, " = " + start if start else "")
        if key in VECTORS:
            read += "  Message.%s = %s(%s);\n" % (member, "ToRate" if key in RATES else "ToDirection", place)
        else:
            read += "  Read(%s, Message.%s);\n" % (place, member)
        return text, read

    @staticmethod
    def _type_member():
        return ("%s  EHedgehogEventType Type = EHedgehogEventType::Other;\n  /// As sent: \"effect_ended\".\n%s  FString TypeName;\n" % (
            PROPERTY, PROPERTY), '  Read(Value["type"], Message.Type);\n  Read(Value["type"], Message.TypeName);\n')

    def _kind(self, owner, name, key, schema):
        """The member's type, and what it starts with: "" for a structure; None for what is empty when it was not sent."""
        kind = schema.get("type")
        if key in VECTORS:
            return "FVector", "FVector::ZeroVector"
        if key == QUATERNION:
            return "FQuat", "FQuat::Identity"
        if kind in PLAIN:
            return PLAIN[kind]
        if kind == "array":
            items = schema["items"]
            if items.get("type") == "object":
                # One of the effects is an effect.
                return "TArray<%s>" % self.add(owner, name + pascal(key)[:-1], items), None
            return "TArray<%s>" % self._kind(owner, name, key, items)[0], None
        if kind == "object":
            return self.add(owner, name + pascal(key), schema), ""
        assert kind == "string", key
        return "FString", None


def header_text(message, includes, types, structures):
    text = HEAD + NOTES + '#pragma once\n\n#include "CoreMinimal.h"\n' + "".join('#include "%s"\n' % one for one in includes)
    text += '\n#include "hedgehog_%s.generated.h"\n' % message.lower()
    if types:
        text += "\nUENUM(BlueprintType)\nenum class EHedgehogEventType : uint8 {\n  /// One of a later daemon: see TypeName.\n  Other,\n"
        text += "".join("  %s,\n" % pascal(one) for one in types) + "};\n"
    return text + "".join(structures.declared[message])


def reader_header_text():
    text = HEAD + '#pragma once\n\n#include "core/json.h"\n' + "".join('#include "hedgehog_%s.h"\n' % one.lower() for one in MESSAGES)
    text += "\nnamespace hedgehog::unreal {\n\n"
    return text + "".join("void Read(const Json& Value, FHedgehog%s& Message);\n" % one for one in MESSAGES) + "\n}  // namespace hedgehog::unreal\n"


def reader_source_text(structures):
    text = HEAD + '#include "hedgehog_message_json.h"\n\n#include <cstdint>\n\n#include "core/methods.h"\n' + HELPERS
    own = [name for name, _ in structures.readers if name not in MESSAGES]
    text += "\n" + "".join("static void Read(const Json& Value, FHedgehog%s& Message);\n" % name for name in own) + LIST
    for name, reads in structures.readers:
        text += "\n%svoid Read(const Json& Value, FHedgehog%s& Message) {\n%s}\n" % ("" if name in MESSAGES else "static ", name, reads)
    return text + "\n}  // namespace hedgehog::unreal\n"


def files(document, public, private):
    schemas = document["components"]["schemas"]
    structures = Structures()
    for message in MESSAGES:
        structures.add(message, message, schemas[message])
    return {public / "hedgehog_event.h": header_text("Event", [], schemas["Event"]["properties"]["type"]["examples"], structures),
            public / "hedgehog_status.h": header_text("Status", ["hedgehog_event.h"], [], structures),
            private / "hedgehog_message_json.h": reader_header_text(),
            private / "hedgehog_message_json.cpp": reader_source_text(structures)}
