#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# licences.sh OUT PROGRAM ...: the licence files (Debian's) of the shared libraries that the programs load, in OUT, but
# for those of the C and C++ libraries, which a wheel does not hold.  Scripts among the programs load none.
# LIBRARIES=FOLDER: programs for another processor, whose libraries apt_copy.sh unpacked into FOLDER, or static ones,
# whose licences scripts/glibc228.sh put into FOLDER/licences.
set -euo pipefail
out=$1; shift
command -v dpkg-query > /dev/null || exit 0
mkdir -p "$out"
[ ! -d "${LIBRARIES:-}/licences" ] || exec cp -r "$LIBRARIES/licences/." "$out"
copy() {  # PACKAGE FOLDER
    case $1 in
        "" | libc6 | libgcc-s1 | libstdc++6) ;;
        *) cp "$2/usr/share/doc/$1/copyright" "$out/$1" ;;
    esac
}
if [ -n "${LIBRARIES:-}" ]; then
    for program; do
        qemu-aarch64-static -L "$LIBRARIES" -E LD_TRACE_LOADED_OBJECTS=1 "$program" 2> /dev/null || :
    done | awk '$2 == "=>" { print $1 }' | sort -u | while read -r library; do
        copy "$(awk -v name="$library" '$1 ".so." $2 == name { print $3; exit }' "$LIBRARIES/shlibs")" "$LIBRARIES"
    done
    exit 0
fi
{ ldd "$@" 2> /dev/null || :; } | awk '$2 == "=>" && $3 ~ /^\// { print $3 }' | sort -u | while read -r library; do
    package=$({ dpkg-query -S "$library" || dpkg-query -S "$(realpath "$library")"; } 2> /dev/null | cut -d : -f 1)
    copy "$package" ""
done
