#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# setup.sh PARTS: installs the Debian packages that these parts of luxpipe need, if any is missing; does nothing
# otherwise.  Parts: tools (those that measure), ptrace, tests, demo, fuzz, deb, wheel, arm64 (built and tried for ARM
# on another processor), windows and wine (the .zip, and tried), chroot, site.
# It says what it will install, then runs `apt-get` (as root, or through sudo), and changes nothing else.
# `make SETUP=no` leaves it out.  Elsewhere than on Debian and its relatives it only names what is needed.
set -eu

packages=
for part in "$@"; do
    case $part in
        tools) packages="$packages g++ make git cmake ninja-build
            libcli11-dev libmicrohttpd-dev libopenexr-dev libimath-dev libfmt-dev libpng-dev libpugixml-dev" ;;
        ptrace) packages="$packages libembree-dev ocl-icd-opencl-dev opencl-headers opencl-clhpp-headers" ;;
        tests) packages="$packages doctest-dev mandoc pocl-opencl-icd
            python3-numpy python3-pandas python3-pytest python3-tqdm mypy
            chromium chromium-driver python3-selenium python3-pil" ;;  # PoCL: OpenCL on the CPU; the page of vcview
        demo) packages="$packages gnuplot-nox" ;;                          # the plot
        fuzz) packages="$packages clang" ;;
        wheel) packages="$packages python3-venv dpkg-dev" ;;               # its tools come from the package index
        site) packages="$packages mandoc python3-venv" ;;
        arm64) packages="$packages g++-aarch64-linux-gnu qemu-user-static" ;;
        windows) packages="$packages g++-mingw-w64-x86-64-posix dpkg-dev cmake ninja-build make git mandoc" ;;
        wine) packages="$packages wine wine64" ;;
        chroot) packages="$packages debootstrap" ;;
        deb) packages="$packages dpkg-dev file" ;;                         # find which libraries the programs need
        *) echo "setup: no part \"$part\": tools ptrace tests demo fuzz deb wheel arm64 windows wine chroot site" >&2
           exit 1 ;;
    esac
done

if ! command -v dpkg-query > /dev/null || ! command -v apt-get > /dev/null; then
    echo "setup: no apt-get here; please see to it that these (Debian's names) are installed:$packages" >&2
    exit 0
fi

missing=
for package in $packages; do
    state=$(dpkg-query -W -f '${Status}' "$package" 2> /dev/null || true)
    [ "$state" = "install ok installed" ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

sudo=
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo > /dev/null; then
        echo "setup: missing packages and neither root nor sudo; as root run: apt-get install$missing" >&2
        exit 2
    fi
    sudo=sudo
fi

echo "setup: these Debian packages are missing and will be installed with apt-get:$missing" >&2
echo "setup: (make SETUP=no installs nothing and builds with what is there)" >&2
$sudo apt-get update -q
# shellcheck disable=SC2086  # the list is meant to be split
$sudo env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing
