#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# deb_for.sh SUITE OUT: a Debian package for another Debian (trixie), in OUT: made in a Debian of that name, OUT/SUITE
# (by debootstrap where there is none yet), from the files that git knows.  As root, with a network.
# ARCH=arm64: for ARM, by that Debian's cross compiler and libraries.
set -euo pipefail
suite=$1
mkdir -p "$2" && out=$(cd "$2" && pwd) && top=$(cd "$(dirname "$0")/.." && pwd)
root=$out/$suite
[ -x "$root/bin/bash" ] || debootstrap --variant=minbase "$suite" "$root" > /dev/null
commit_time=$(git -C "$top" log -1 --format=%ct)
rm -rf "$root/source" "$root/deb" && mkdir "$root/source"
(cd "$top" && git ls-files -z | tar -c --null -T -) | tar -x -C "$root/source"
unshare -mp --fork --mount-proc="$root/proc" chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin LC_ALL=C \
    SOURCE_DATE_EPOCH="${SOURCE_DATE_EPOCH:-$commit_time}" JOBS="${JOBS:-$(nproc)}" FLAGS="${FLAGS:-}" \
    ARCH="${ARCH:-}" bash -eo pipefail -c '
    cd /source && { sh scripts/setup.sh tools ptrace deb $ARCH && { [ -z "$ARCH" ] ||
        sh scripts/arm64.sh build-arm64/root; } && bash scripts/deb.sh /deb; } > /deb.log 2>&1 ||
        { tail -n 30 /deb.log >&2; exit 2; }'
mkdir -p "$out/for-$suite" && rm -f "$out/for-$suite"/*.deb
cp "$root"/deb/luxpipe_*.deb "$out/for-$suite"
ls "$out/for-$suite"/*.deb
