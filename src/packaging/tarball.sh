#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes a tarball of the program that runs on any Linux of the same processor, from any folder: every library that the
# program uses is inside, the C library and its loader, too. OpenImageIO is not: it would be 360 MB of libraries.
#   tarball.sh PACKED FILE    PACKED: the tarball of CPack; FILE: what is made
# Needs Debian, whose packages the libraries come from. Their versions and licences stand in share/doc/candelabra/libraries.
set -euo pipefail

own=$(realpath "$(dirname "$0")")
packed=$(realpath "$1")
made=$(realpath -m "$2")
name=$(basename "$made" .tar.gz)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
root=$folder/$name
mkdir "$root"
tar -xf "$packed" -C "$root" --strip-components=1
rm -rf "$root/lib/python3" "$root/lib/candelabra/libcandelabra_oiio.so"
mkdir -p "$root/libexec" "$root/share/doc/candelabra/libraries"
mv "$root/bin/candelabra" "$root/libexec/candelabra"
install -m 755 "$own/launch.sh" "$root/bin/candelabra"

# Lines of a library's file name and its path; the loader has no other name than its path.
libraries_of() {
    ldd "$@" | awk '$2 == "=>" && $3 ~ /^\// { print $1, $3 } $1 ~ /^\/.*\/ld-/ { print "loader", $1 }' | sort -u
}
libraries=$(libraries_of "$root/libexec/candelabra" "$root"/lib/candelabra/*.so)
# Their packages, by file name. Packages know a file with or without /usr.
declare -A packages
while IFS=: read -r package path; do
    packages[${path##*/}]=${package%%:*}
done < <(awk '{ print $2; sub("^(/usr)?", "/usr", $2); print $2; sub("^/usr", "", $2); print $2 }' <<< "$libraries" |
             xargs dpkg-query -S 2> /dev/null | sed '/^diversion by /d; s/^\([^:]*\):[^ ]* /\1:/; s/: /:/')
list=$root/share/doc/candelabra/libraries/README
{
    echo "Libraries in lib/candelabra and libexec, as Debian built them. Their sources: apt-get source PACKAGE=VERSION,"
    echo "or https://snapshot.debian.org/package/PACKAGE/VERSION/; their licences lie here."
    echo
} > "$list"
while read -r library path; do
    if [ "$library" = loader ]; then cp -L "$path" "$root/libexec/loader"
    else cp -L "$path" "$root/lib/candelabra/$library"; fi
    package=${packages[${path##*/}]:-}
    [ -n "$package" ] || { echo "tarball.sh: $path belongs to no package" >&2; exit 1; }
    dpkg-query -W -f='${source:Package} ${source:Version}: '"$library"'\n' "$package" | head -n 1 >> "$list"
    cp -L "/usr/share/doc/$package/copyright" "$root/share/doc/candelabra/libraries/$package"
done <<< "$libraries"
# Sorted, and without times and owners: the same bytes from the same files.
tar -C "$folder" --sort=name --owner=0 --group=0 --numeric-owner --mtime=@0 -c "$name" | gzip -n > "$made"
