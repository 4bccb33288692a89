#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# deb.sh OUT: builds a Debian package of the source tree in OUT, in a fresh build folder there, and looks it over with
# lintian where there is one.  The time in it is SOURCE_DATE_EPOCH, else that of the last commit, else of CHANGELOG.md.
# ARCH=arm64: for ARM, by the compiler and libraries of cmake/arm64.cmake.
set -eu
mkdir -p "$1" && out=$(cd "$1" && pwd) && top=$(cd "$(dirname "$0")/.." && pwd)
commit_time=$(git -C "$top" log -1 --format=%ct 2> /dev/null || stat -c %Y "$top/CHANGELOG.md")
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$commit_time} LC_ALL=C
umask 022
libraries=$top/build-arm64/root

# what dpkg-shlibdeps says of the programs, from the list of these libraries: none of their packages is installed
arm64_depends() {
    mkdir -p "$out/build/control/debian"
    cd "$out/build/control"
    printf 'Source: luxpipe\n\nPackage: luxpipe\nArchitecture: any\n' > debian/control
    grep -l '^.ELF' "$out"/build/bin/* |
        DEB_HOST_ARCH=arm64 xargs dpkg-shlibdeps -O -L"$libraries/shlibs" -l"$libraries/usr/lib/aarch64-linux-gnu" \
            -l"$libraries/lib/aarch64-linux-gnu" 2> warnings | sed 's/^shlibs:Depends=//'
}
case ${ARCH:-$(dpkg --print-architecture)} in
    "$(dpkg --print-architecture)") toolchain= ;;
    arm64) toolchain=-DCMAKE_TOOLCHAIN_FILE=$top/cmake/arm64.cmake ;;
    *) echo "deb: no way to build for $ARCH here: arm64 or this machine's" >&2; exit 1 ;;
esac

rm -rf "$out/build" "$out"/luxpipe_*.deb
cmake -S "$top" -B "$out/build" -G Ninja --log-level=WARNING -DCMAKE_INSTALL_PREFIX=/usr -DLUXPIPE_DEB=ON \
    -DCMAKE_UNITY_BUILD=ON $toolchain ${FLAGS:-} > /dev/null
cmake --build "$out/build" -j "${JOBS:-$(nproc)}" --target tools > "$out/build/log" ||
    { tail -n 30 "$out/build/log" >&2; exit 2; }
foreign=()
[ -z "$toolchain" ] || foreign=(-D CPACK_DEBIAN_PACKAGE_ARCHITECTURE=arm64 -D CPACK_DEBIAN_PACKAGE_SHLIBDEPS=OFF
    -D CPACK_DEBIAN_PACKAGE_DEPENDS="$(arm64_depends)")
(cd "$out/build" && cpack -B "$out" --config CPackConfig.cmake "${foreign[@]}" > /dev/null)
rm -rf "$out/_CPack_Packages"
package=$(ls "$out"/luxpipe_*.deb)
if command -v lintian > /dev/null; then
    lintian --allow-root --fail-on error "$package" >&2
fi
echo "$package"
