#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# zip.sh OUT: builds the programs for Windows (cmake/windows.cmake) and puts them into a .zip in OUT, with manual pages
# as HTML and the licences of what is linked in.  The time in it is SOURCE_DATE_EPOCH, else that of the last commit.
set -eu
mkdir -p "$1" && out=$(cd "$1" && pwd) && top=$(cd "$(dirname "$0")/.." && pwd)
time=${SOURCE_DATE_EPOCH:-$(git -C "$top" log -1 --format=%ct 2> /dev/null || stat -c %Y "$top/CHANGELOG.md")}
umask 022

build=$top/build-windows
sh "$top/scripts/windows.sh" "$build/libraries"
cmake -S "$top" -B "$build" -G Ninja --log-level=WARNING -DCMAKE_TOOLCHAIN_FILE="$top/cmake/windows.cmake" \
    -DLUXPIPE_OPENCL=OFF -DBUILD_TESTING=OFF -DCMAKE_UNITY_BUILD=ON ${FLAGS:-} > /dev/null
cmake --build "$build" -j "${JOBS:-$(nproc)}" --target tools > "$build/log" ||
    { tail -n 30 "$build/log" >&2; exit 2; }

name=luxpipe-$(sed -n 's/^set(CPACK_PACKAGE_VERSION "\(.*\)")/\1/p' "$build/CPackConfig.cmake")-windows-x86_64
rm -rf "$out/$name" "$out"/luxpipe-*.zip
mkdir -p "$out/$name/bin" "$out/$name/manual"
for tool in ptrace ptaccum vcmetrics vcregion vcyear; do
    # -p: otherwise strip writes the time of day into the program
    x86_64-w64-mingw32-strip -p -o "$out/$name/bin/$tool.exe" "$build/bin/$tool.exe"
    mandoc -T html -O man=%N.%S.html "$top/man/$tool.1" > "$out/$name/manual/$tool.1.html"
done
cp "$top/LICENSE" "$out/$name/LICENSE.txt"
cp -r "$build/share" "$out/$name/"  # the library of materials
cp -r "$build/libraries/licences" "$out/$name/"
cp /usr/share/doc/mingw-w64-common/copyright "$out/$name/licences/mingw-w64"
cp /usr/share/doc/gcc-mingw-w64-base/copyright "$out/$name/licences/gcc"
(cd "$out" && python3 - "$name" "$time" << 'END'
import os, sys, time, zipfile
name, day = sys.argv[1], time.gmtime(int(sys.argv[2]))[:6]
with zipfile.ZipFile(name + ".zip", "w", zipfile.ZIP_DEFLATED) as archive:
    for path in sorted(os.path.join(at, file) for at, _, files in os.walk(name) for file in files):
        with open(path, "rb") as file:
            archive.writestr(zipfile.ZipInfo(path, day), file.read(), zipfile.ZIP_DEFLATED)
END
)
rm -r "$out/$name"
echo "$out/$name.zip"
