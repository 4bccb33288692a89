#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# glibc228.sh FOLDER: builds in FOLDER the libraries of luxpipe for x86-64 Linux from glibc 2.28 on (RHEL 8, Debian 10),
# static, from Debian 12's sources, and the compiler for all of it: zig's clang, which knows that C library's symbols
# and brings a C++ library of its own (cmake/glibc228.cmake names FOLDER).  OpenCL's loader is Debian 11's.
# Nothing is installed; removing FOLDER removes it.
set -eu
[ ! -e "$1/complete" ] || exit 0
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$1"
mkdir -p "$1/bin" "$1/cache" "$1/usr/lib"
root=$(cd "$1" && pwd)
log=$root/log
trap '[ -e "$root/complete" ] || tail -n 20 "$log" >&2' EXIT
echo "glibc228: zig comes from the package index, libraries are built in $1 from Debian's sources" >&2

python3 -m venv "$root/zig"
"$root/zig/bin/pip" install -q ziglang==0.17.1
for name in clang:cc clang++:c++; do
    printf '#!/bin/sh\nexec "%s" %s -target x86_64-linux-gnu.2.28 "$@"\n' \
        "$(ls "$root"/zig/lib/python3*/site-packages/ziglang/zig)" ${name#*:} > "$root/bin/${name%:*}"
    chmod +x "$root/bin/${name%:*}"
done

# zig's runtime library has sin, exp and others of its own, with other last bits: the linker is given a copy of it first
# (cmake/glibc228.cmake) that keeps to itself what glibc has. (And what lib/evalglare calls of its libmvec.)
echo 'int main() {}' | ZIG_GLOBAL_CACHE_DIR=$root/cache "$root/bin/clang" -x c - -o "$root/cache/program"
nm -D "$root"/cache/o/*/lib[cm].so.6 | sed -n 's/.* [A-Za-z] \([^@]*\)@.*/\1/p' | sort -u > "$root/cache/names"
ar p "$root"/cache/o/*/libcompiler_rt.a > "$root/cache/runtime.o"
objcopy --localize-symbols="$root/cache/names" "$root/cache/runtime.o"
ar rcs "$root/usr/lib/libruntime.a" "$root/cache/runtime.o"
echo 'GLIBC_2.22 { global: *; };' > "$root/cache/versions"
echo 'void _ZGVbN2v_sin() {} void _ZGVbN2v_cos() {}' | "$root/bin/clang" -x c - -shared -nostdlib \
    -Wl,-soname,libmvec.so.1 "-Wl,--version-script=$root/cache/versions" -o "$root/usr/lib/libmvec.so"
rm -rf "$root/cache"

sh "$here/apt_copy.sh" "$root" bookworm "$(dpkg --print-architecture)" libcli11-dev opencl-headers opencl-clhpp-headers
sh "$here/apt_copy.sh" "$root/loader" bullseye amd64 ocl-icd-libopencl1
sh "$here/apt_copy.sh" "$root/source" bookworm source zlib imath openexr libpng1.6 fmtlib pugixml libmicrohttpd
sh "$here/apt_copy.sh" "$root/source" bookworm upstream embree  # Debian's patches are for a shared library with TBB
embree=$(sh "$here/embree_trees.sh" "$root/source")
cp "$root"/loader/usr/lib/x86_64-linux-gnu/libOpenCL.so.1 "$root/usr/lib"
ln -s libOpenCL.so.1 "$root/usr/lib/libOpenCL.so"

source_of() { ls -d "$root/source/$1"-*/; }
by_cmake() {  # NAME FLAGS...
    source=$(source_of "$1")
    shift
    cmake -S "$source" -B "$source/out" -G Ninja -DCMAKE_TOOLCHAIN_FILE="$here/../cmake/glibc228.cmake" \
        -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF -DBUILD_TESTING=OFF -DCMAKE_POSITION_INDEPENDENT_CODE=ON \
        -DCMAKE_INSTALL_PREFIX="$root/usr" -DCMAKE_INSTALL_LIBDIR=lib "$@"
    cmake --build "$source/out" -j "${JOBS:-$(nproc)}" --target install
}
by_configure() {  # NAME FLAGS...
    source=$(source_of "$1")
    shift
    (cd "$source" && CC="$root/bin/clang" CFLAGS='-O2 -fPIC' ./configure --prefix="$root/usr" "$@" &&
        make -j "${JOBS:-$(nproc)}" && make install)
}
{
    by_configure zlib --static
    by_configure libmicrohttpd --host=x86_64-linux-gnu --disable-shared --disable-https --disable-doc \
        --disable-examples --disable-curl
    by_cmake libpng1.6 -DPNG_SHARED=OFF -DPNG_TESTS=OFF
    by_cmake imath
    by_cmake openexr -DOPENEXR_BUILD_TOOLS=OFF -DOPENEXR_INSTALL_EXAMPLES=OFF
    by_cmake fmtlib -DFMT_TEST=OFF -DFMT_DOC=OFF
    by_cmake pugixml
    # shellcheck disable=SC2086  # several words
    by_cmake embree $embree
} > "$log" 2>&1
mkdir "$root/licences"
for source in "$root"/source/*/; do
    text=$source/debian/copyright
    [ -e "$text" ] || text=$source/LICENSE.txt
    name=$(basename "$source")
    cp "$text" "$root/licences/${name%%-*}"
done
cp "$root/loader/usr/share/doc/ocl-icd-libopencl1/copyright" "$root/licences/ocl-icd-libopencl1"
cp "$root"/zig/lib/python3*/site-packages/ziglang/lib/libcxx/LICENSE.TXT "$root/licences/libcxx"
rm -rf "$root/source" "$root/loader"
: > "$root/complete"
