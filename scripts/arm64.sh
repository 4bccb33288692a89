#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# arm64.sh FOLDER: unpacks into FOLDER the libraries for ARM (aarch64) that luxpipe is built with, of this Debian
# (cmake/arm64.cmake names FOLDER).  Nothing is installed; removing FOLDER removes them.
set -eu
[ ! -e "$1/complete" ] || exit 0
here=$(dirname "$0")
echo "arm64: Debian's libraries for ARM are fetched into $1" >&2
rm -rf "$1"
suite=$(. /etc/os-release && echo "${VERSION_CODENAME:-bookworm}")
compiler=$(aarch64-linux-gnu-g++ -dumpversion)
sh "$here/apt_copy.sh" "$1" "$suite" arm64 libc6-dev "libstdc++-$compiler-dev" libcli11-dev libmicrohttpd-dev \
    libopenexr-dev libimath-dev libfmt-dev libpng-dev libpugixml-dev libembree-dev ocl-icd-opencl-dev opencl-headers \
    opencl-clhpp-headers doctest-dev || exit 2
[ -e "$1/lib" ] || ln -s usr/lib "$1/lib"  # since Debian 13 a link, which no package brings
# links to /lib/... would lead to this machine's libraries
find "$1" -type l -lname '/*' | while read -r link; do
    ln -sfnr "$1$(readlink "$link")" "$link"
done
: > "$1/complete"
