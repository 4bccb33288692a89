#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# macos.sh BUILD: does every file of lib and tools compile for macOS (ARM)?  The compiler and the system's headers are
# zig's, from the package index (ziglang); the libraries' headers are this machine's.  Nothing is linked, nothing runs.
set -eu
top=$(cd "$(dirname "$0")/.." && pwd)
mkdir -p "$1/include" && build=$(cd "$1" && pwd)
[ -e "$build/venv" ] || { python3 -m venv "$build/venv" && "$build/venv/bin/pip" install -q ziglang; }
for header in CL CLI Imath OpenEXR embree3 embree4 fmt libpng16 microhttpd.h png.h pngconf.h pnglibconf.h \
    pugiconfig.hpp pugixml.hpp; do
    [ ! -e "/usr/include/$header" ] || ln -sfn "/usr/include/$header" "$build/include/"
done
ln -sfn /usr/include/CL "$build/include/OpenCL"  # its name there
cmake -S "$top" -B "$build/linux" -G Ninja --log-level=WARNING -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DBUILD_TESTING=OFF \
    -DCMAKE_UNITY_BUILD=ON > /dev/null
cmake --build "$build/linux" --target lib/device/kernel_source.cpp > /dev/null
python3 - "$build" << 'END' | sort -u > "$build/commands"
import json, shlex, sys
build = sys.argv[1]
for entry in json.load(open(build + "/linux/compile_commands.json")):
    words = shlex.split(entry["command"])
    words = [w for w in words if w != "-DLUX_HAVE_LIBMVEC"]  # glibc alone, on x86-64
    kept = [w for k, w in enumerate(words) if w.startswith(("-D", "-I", "-isystem")) or words[k - 1] == "-isystem"]
    if not any(w.startswith("-mavx") for w in words):  # x86-64 alone
        print(shlex.join(kept + [entry["file"]]))
END
failed=0
while read -r line; do
    eval "set -- $line"
    "$build/venv/bin/python" -m ziglang c++ -target aarch64-macos -std=c++17 -O0 -Wno-deprecated-declarations \
        -c -o "$build/object.o" -isystem "$build/include" "$@" < /dev/null || failed=$((failed + 1))
done < "$build/commands"
echo "macos: $(wc -l < "$build/commands") files, $failed that do not compile"
[ "$failed" -eq 0 ]
