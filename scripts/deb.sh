#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# deb.sh OUT: builds a Debian package of the source tree in OUT, in a fresh build folder there, and looks it over with
# lintian where there is one.  The time in it is SOURCE_DATE_EPOCH, else that of the last commit, else of CHANGELOG.md.
set -eu
mkdir -p "$1" && out=$(cd "$1" && pwd) && top=$(cd "$(dirname "$0")/.." && pwd)
commit_time=$(git -C "$top" log -1 --format=%ct 2> /dev/null || stat -c %Y "$top/CHANGELOG.md")
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$commit_time} LC_ALL=C
umask 022

rm -rf "$out/build" "$out"/luxpipe_*.deb
cmake -S "$top" -B "$out/build" -G Ninja --log-level=WARNING -DCMAKE_INSTALL_PREFIX=/usr -DLUXPIPE_DEB=ON \
    -DCMAKE_UNITY_BUILD=ON ${FLAGS:-} > /dev/null
cmake --build "$out/build" -j "${JOBS:-$(nproc)}" --target tools > /dev/null
(cd "$out/build" && cpack -B "$out" --config CPackConfig.cmake > /dev/null)
rm -rf "$out/_CPack_Packages"
package=$(ls "$out"/luxpipe_*.deb)
if command -v lintian > /dev/null; then
    lintian --allow-root --fail-on error "$package" >&2
fi
echo "$package"
