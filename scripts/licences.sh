#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# licences.sh OUT PROGRAM ...: the licence files (Debian's) of the shared libraries that the programs load, in OUT, but
# for those of the C and C++ libraries, which a wheel does not hold.  Scripts among the programs load none.
set -euo pipefail
out=$1; shift
command -v dpkg-query > /dev/null || exit 0
mkdir -p "$out"
{ ldd "$@" 2> /dev/null || :; } | awk '$2 == "=>" && $3 ~ /^\// { print $3 }' | sort -u | while read -r library; do
    package=$({ dpkg-query -S "$library" || dpkg-query -S "$(realpath "$library")"; } 2> /dev/null | cut -d : -f 1)
    case $package in
        "" | libc6 | libgcc-s1 | libstdc++6) ;;
        *) cp "/usr/share/doc/$package/copyright" "$out/$package" ;;
    esac
done
