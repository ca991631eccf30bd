#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""sbom.py VERSION COMMIT DATE: the software bill of materials of this tree as SPDX 2.3 JSON on stdout.

Packages: this project; those of cmake/apt/build.txt, in the versions installed here (dpkg-query); those of the pages' lock
file. DATE is UTC, 2026-11-24T12:00:00Z. The same tree on the same machine gives the same bytes. Exit: 69: a Debian package
is not installed.
"""
import base64
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LOCK = "clients/dashboard/package-lock.json"


def debian_alternatives():
    """Lines of build.txt, each as the names of its alternatives."""
    for line in (ROOT / "cmake/apt/build.txt").read_text().splitlines():
        line = line.split("#")[0].strip()
        if line:
            yield [want.split(">=")[0].strip() for want in line.split("|")]


def installed(name):
    """(name, version, architecture), or None."""
    query = ["dpkg-query", "--show", "--showformat", "${db:Status-Status}\t${Version}\t${Architecture}", name]
    done = subprocess.run(query, capture_output=True, text=True, check=False)
    state, _, rest = done.stdout.partition("\t")
    return (name, *rest.split("\t")) if state == "installed" else None


def debian_packages():
    for names in debian_alternatives():
        found = next((one for one in map(installed, names) if one), None)
        if found is None:
            print(f"sbom.py: {' | '.join(names)} is not installed (cmake/bootstrap.sh build)", file=sys.stderr)
            sys.exit(69)
        yield found


def identifier(*parts):
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", "-".join(parts))


def package(kind, name, version, purl, **more):
    return {
        "SPDXID": identifier(kind, name),
        "name": name,
        "versionInfo": version,
        "downloadLocation": "NOASSERTION",
        "filesAnalyzed": False,
        "licenseConcluded": "NOASSERTION",
        "licenseDeclared": more.pop("license", "NOASSERTION"),
        "copyrightText": "NOASSERTION",
        "externalRefs": [
            {"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl", "referenceLocator": purl}],
        **more,
    }


def npm_packages():
    """(package, whether only the build needs it)."""
    for path, entry in json.loads((ROOT / LOCK).read_text())["packages"].items():
        if not path:
            continue
        name = path.split("node_modules/")[-1]
        algorithm, _, digest = entry["integrity"].partition("-")
        checksum = {"algorithm": algorithm.upper(), "checksumValue": base64.b64decode(digest).hex()}
        yield (package("npm", name, entry["version"], f"pkg:npm/{name.replace('@', '%40')}@{entry['version']}",
                       license=entry.get("license", "NOASSERTION"), checksums=[checksum]),
               bool(entry.get("dev")))


def document(version, commit, date):
    root = package("Hedgehog", "hedgehog", version, f"pkg:generic/hedgehog@{version}", license="MIT")
    packages = [root]
    relations = [("SPDXRef-DOCUMENT", "DESCRIBES", root["SPDXID"])]
    for name, installed_version, architecture in debian_packages():
        purl = f"pkg:deb/debian/{name.replace('+', '%2B')}@{installed_version.replace('+', '%2B')}?arch={architecture}"
        packages.append(package("deb", name, installed_version, purl))
        relations.append((packages[-1]["SPDXID"], "BUILD_DEPENDENCY_OF", root["SPDXID"]))
    for one, build_only in npm_packages():
        packages.append(one)
        relations.append((one["SPDXID"], "BUILD_TOOL_OF" if build_only else "DEPENDENCY_OF", root["SPDXID"]))
    return {
        "spdxVersion": "SPDX-2.3",
        "dataLicense": "CC0-1.0",
        "SPDXID": "SPDXRef-DOCUMENT",
        "name": f"hedgehog-{version}",
        "documentNamespace": f"https://spdx.org/spdxdocs/hedgehog-{version}-{commit}",
        "creationInfo": {"created": date, "creators": ["Tool: hedgehog-sbom.py"]},
        "packages": packages,
        "relationships": [
            {"spdxElementId": one, "relationshipType": kind, "relatedSpdxElement": other}
            for one, kind, other in relations],
    }


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    json.dump(document(*sys.argv[1:]), sys.stdout, indent=1, ensure_ascii=False)
    print()
