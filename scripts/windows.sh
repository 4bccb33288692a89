#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# windows.sh FOLDER: builds in FOLDER, for Windows by mingw-w64, the libraries that the programs of the .zip are linked
# with, from Debian 12's sources (cmake/windows.cmake names FOLDER), and their licences in FOLDER/licences.  Nothing is
# installed; removing FOLDER removes them.
set -eu
[ ! -e "$1/complete" ] || exit 0
here=$(cd "$(dirname "$0")" && pwd)
echo "windows: Debian's sources are fetched and built in $1" >&2
rm -rf "$1" "$1.sources"
sh "$here/apt_copy.sh" "$1.sources" bookworm source openexr imath libpng1.6 fmtlib pugixml || exit 2
sh "$here/apt_copy.sh" "$1.sources" bookworm upstream embree || exit 2  # Debian's patches are for TBB
sh "$here/apt_copy.sh" "$1" bookworm amd64 libcli11-dev libz-mingw-w64-dev || exit 2
root=$(cd "$1" && pwd)
rm "$root/usr/x86_64-w64-mingw32/lib/libz.dll.a"  # programs need no DLL

mkdir "$root/licences"
cp "$root/usr/share/doc/libz-mingw-w64-dev/copyright" "$root/licences/zlib"
cp "$root/usr/share/doc/libcli11-dev/copyright" "$root/licences/cli11"

# library NAME OPTION...
library() {
    source=$(echo "$root.sources/$1"-*/)
    text=$source/debian/copyright
    [ -e "$text" ] || text=$source/LICENSE.txt
    cp "$text" "$root/licences/$1"
    shift
    {
        cmake -S "$source" -B "$source/for-windows" -G Ninja -DCMAKE_TOOLCHAIN_FILE="$here/../cmake/windows.cmake" \
            -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$root/usr" -DBUILD_SHARED_LIBS=OFF \
            -DBUILD_TESTING=OFF -DCMAKE_CXX_FLAGS="-ffile-prefix-map=$root.sources=." "$@"
        cmake --build "$source/for-windows" --target install
    } > "$root/log" 2>&1 || { tail -n 20 "$root/log" >&2; exit 2; }
}
library fmtlib -DFMT_TEST=OFF -DFMT_DOC=OFF
library pugixml
library libpng1.6 -DPNG_SHARED=OFF -DPNG_TESTS=OFF -DPNG_EXECUTABLES=OFF
library imath
library openexr -DOPENEXR_BUILD_TOOLS=OFF -DOPENEXR_INSTALL_EXAMPLES=OFF -DOPENEXR_INSTALL_TOOLS=OFF
options=$(sh "$here/embree_trees.sh" "$root.sources")
# shellcheck disable=SC2086  # several words
library embree $options -DEMBREE_IGNORE_CMAKE_CXX_FLAGS=OFF
: > "$1/complete"
