#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What is installed for desktops, shells and readers, asked by the programs that read it; each is left out with a word
# where it is not installed.
#   packaging.sh PROGRAM
set -uo pipefail

program=$(realpath "$1")
root=$(realpath "$(dirname "$0")/../..")
own=$root/src/packaging
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0

# with TOOL NAME COMMAND...
with() {
    local tool=$1 name=$2
    shift 2
    if ! command -v "$tool" > /dev/null; then
        echo "left out: $name ($tool is not installed)"
    elif "$@" > "$folder/out.txt" 2>&1; then
        echo "ok: $name"
    else
        echo "FAILED: $name"
        cat "$folder/out.txt"
        failures=$((failures + 1))
    fi
}

metainfo() {  # ADDRESS-OF-PICTURES
    cmake -DINPUT="$own/candelabra.metainfo.xml" -DOUTPUT="$folder/candelabra.metainfo.xml" -DPICTURES="$1" \
        -P "$own/metainfo.cmake" && appstreamcli validate --no-net "$folder/candelabra.metainfo.xml"
}
pictures() {
    metainfo https://example.org/pictures && for picture in $(sed -n 's,.*/pictures/\(.*\)</image>,\1,p' \
        "$folder/candelabra.metainfo.xml"); do [ -s "$root/examples/pictures/$picture" ] || return 1; done
}
with appstreamcli "AppStream data" metainfo ""
with appstreamcli "AppStream data with screenshots" pictures

# One version everywhere.
version=$("$program" --version | cut -d ' ' -f 2)
versions() {
    [ "$(sed -n 's/.*<release version="\([^"]*\)".*/\1/p' "$own/candelabra.metainfo.xml" | head -n 1)" = "$version" ] &&
        [ "$(sed -n 's/^## \([0-9][0-9.]*\).*/\1/p' "$root/CHANGELOG.md" | head -n 1)" = "$version" ]
}
with sed "version $version in AppStream data and CHANGELOG.md" versions
with desktop-file-validate "desktop file" desktop-file-validate "$own/candelabra.desktop"
mkdir -p "$folder/mime/packages"
cp "$own/candelabra-mime.xml" "$folder/mime/packages/candelabra.xml"
mime() { update-mime-database "$folder/mime" && grep -q 'pov' "$folder/mime/globs2"; }
with update-mime-database "MIME types" mime

for shell in bash zsh fish; do "$program" --completion $shell > "$folder/completion.$shell"; done
in_bash() {
    bash -c ". '$folder/completion.bash'; COMP_WORDS=(candelabra --lay); COMP_CWORD=1; _candelabra
             [ \"\${COMPREPLY[*]}\" = --layers ]"
}
in_zsh() {
    cp "$folder/completion.zsh" "$folder/_candelabra"
    zsh -fc "fpath=('$folder' \$fpath); autoload -Uz compinit && compinit -u -d '$folder/dump'
             [[ \$_comps[candelabra] == _candelabra ]] && autoload +X _candelabra"
}
in_fish() { fish --no-config -c "source '$folder/completion.fish'; complete -C 'candelabra --lay' | grep -q -- --layers"; }
with bash "completion in bash" in_bash
with zsh "completion in zsh" in_zsh
with fish "completion in fish" in_fish

citation() {
    python3 - "$root/CITATION.cff" "$program" << 'PYTHON'
import subprocess, sys, yaml
cff = yaml.safe_load(open(sys.argv[1]))
assert {"cff-version", "message", "title", "authors"} <= set(cff), "what every CITATION.cff has"
assert cff["cff-version"] == "1.2.0" and cff["type"] in ("software", "dataset")
for work in [cff, *cff["references"]]:
    assert work["title"] and all("name" in a or "family-names" in a for a in work["authors"])
assert all({"type", "title", "authors"} <= set(work) for work in cff["references"])
version = subprocess.run([sys.argv[2], "--version"], capture_output=True, text=True).stdout.split()[1]
assert cff["version"] == version, (cff["version"], version)
PYTHON
}
if python3 -c 'import yaml' 2> /dev/null; then with python3 "CITATION.cff" citation; else echo "left out: CITATION.cff (no yaml)"; fi
with cffconvert "CITATION.cff by its own tool" cffconvert --validate -i "$root/CITATION.cff"
with node "the extension of VS Code" node "$root/tests/production/vscode_client.js" "$program"
vsix() {
    python3 - "$(dirname "$program")/candelabra-$version.vsix" "$version" << 'PYTHON'
import json, sys, zipfile
from xml.etree import ElementTree
package = zipfile.ZipFile(sys.argv[1])
assert package.testzip() is None
names = set(package.namelist())
types = ElementTree.fromstring(package.read("[Content_Types].xml"))
known = {each.get("Extension") for each in types}
assert all("." + name.rsplit(".", 1)[1] in known for name in names if not name.endswith("/") and name[0] != "["), names
manifest = ElementTree.fromstring(package.read("extension.vsixmanifest"))
space = "{http://schemas.microsoft.com/developer/vsx-schema/2011}"
facts = json.loads(package.read("extension/package.json"))
identity = manifest.find(f"{space}Metadata/{space}Identity")
assert identity.get("Version") == facts["version"] == sys.argv[2]
assert identity.get("Publisher") == facts["publisher"] and identity.get("Id") == facts["name"]
assert all(each.get("Path") in names for each in manifest.iter(f"{space}Asset"))
parts = facts["contributes"]
for path in [facts["main"], *(each["path"] for each in parts["grammars"] + parts["snippets"]),
             *(each["configuration"] for each in parts["languages"])]:
    assert "extension/" + path.removeprefix("./") in names, path
for name in names:
    if name.endswith(".json"):
        json.loads(package.read(name))
PYTHON
}
if [ -e "$(dirname "$program")/candelabra-$version.vsix" ]; then with python3 "the .vsix" vsix
else echo "left out: the .vsix (not made yet)"; fi
refused() { ! INSTALL=no PATH="$folder/bin" /usr/bin/bash "$root/tests/install_packages.sh" && grep -q "to install them:" "$folder/out.txt"; }
mkdir -p "$folder/bin"
ln -s /usr/bin/grep /usr/bin/id "$folder/bin/"
with bash "what is missing is said, and not installed" refused
for page in candelabra.1 candelabra-fmt.1 candelabra-lsp.1 candelabra-merge.1 candelabra-relight.1 candelabra-solve.1 candelabra-python.3 candelabra-scene.5 \
    candelabra-lights.7 candelabra-povray.7 candelabra-stdlib.7 candelabra-tutorial.7; do
    made=$(dirname "$program")/man/$page
    [ -e "$made" ] || { echo "left out: $page (not made yet)"; continue; }
    manual() { [ -z "$(man --warnings -E UTF-8 -l -Tutf8 -Z "$made" 2>&1 > /dev/null)" ]; }
    with man "manual page $page" manual
done
exit $((failures > 0))
