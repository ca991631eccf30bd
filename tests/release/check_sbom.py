# SPDX-License-Identifier: MIT
"""check_sbom.py FILE TREE: checks that FILE is a document of SPDX 2.3 with every package of TREE's lists."""
import json
import re
import subprocess
import sys

document = json.load(open(sys.argv[1], encoding="utf-8"))
tree = sys.argv[2]


def expect(condition, what):
    if not condition:
        sys.exit(f"tests/release: {what}")


# The requirements of clauses 6 to 11 of SPDX 2.3.
expect(document["spdxVersion"] == "SPDX-2.3" and document["dataLicense"] == "CC0-1.0", "version")
expect(document["SPDXID"] == "SPDXRef-DOCUMENT" and document["name"] == "hedgehog-99.0.0", "document")
expect(re.fullmatch(r"https://[^#]+-99\.0\.0-[0-9a-f]{40}", document["documentNamespace"]), "namespace")
expect(re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", document["creationInfo"]["created"]), "created")
expect(all(re.match(r"(Tool|Person|Organization): ", one) for one in document["creationInfo"]["creators"]), "creators")
packages = {one["SPDXID"]: one for one in document["packages"]}
expect(len(packages) == len(document["packages"]), "two packages have one identifier")
for key, one in packages.items():
    expect(re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", key), f"{key} is no identifier")
    expect(one["name"] and one["downloadLocation"] == "NOASSERTION" and one["filesAnalyzed"] is False, key)
    purl = one["externalRefs"][0]["referenceLocator"]
    expect(re.fullmatch(r"pkg:(deb/debian|npm|generic)/[^@\s]+@[^@\s]+", purl), f"{purl} is no package URL")
    for checksum in one.get("checksums", []):
        expect(checksum["algorithm"] == "SHA512" and re.fullmatch(r"[0-9a-f]{128}", checksum["checksumValue"]), key)
related = {one["spdxElementId"] for one in document["relationships"]}
for one in document["relationships"]:
    expect({one["spdxElementId"], one["relatedSpdxElement"]} <= {"SPDXRef-DOCUMENT", *packages}, one)
    expect(one["relationshipType"] in ("DESCRIBES", "BUILD_DEPENDENCY_OF", "BUILD_TOOL_OF", "DEPENDENCY_OF"), one)
expect(set(packages) - related == {"SPDXRef-Hedgehog-hedgehog"}, "a package has no relation")

versions = {one["name"]: one["versionInfo"] for one in packages.values()}
lines = [line.split("#")[0] for line in open(f"{tree}/cmake/apt/build.txt", encoding="utf-8")]
for line in filter(str.strip, lines):
    found = [name for name in re.findall(r"(?:^|\|)\s*([a-z0-9.+-]+)", line) if name in versions]
    expect(len(found) == 1, f"none or several of {line.strip()}")
    installed = subprocess.check_output(["dpkg-query", "-W", "-f=${Version}", found[0]], text=True)
    expect(versions[found[0]] == installed, f"{found[0]} is installed as {installed}")
locked = json.load(open(f"{tree}/clients/dashboard/package-lock.json", encoding="utf-8"))["packages"]
for path, entry in locked.items():
    expect(not path or versions.get(path.split("node_modules/")[-1]) == entry["version"], f"{path} is missing")
print(f"{len(packages) - 1} packages")
