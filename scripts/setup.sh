#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Installs the Debian packages luxpipe is built from, if any is missing; does nothing when all are there.
# It runs `apt-get` (as root, or through sudo) and changes nothing else.  Elsewhere than on Debian and its
# relatives it only names what is needed.
set -eu

build="g++ make cmake ninja-build"                                      # to compile
libraries="libembree-dev libopenexr-dev libimath-dev libcli11-dev libfmt-dev libpng-dev libpugixml-dev"
opencl="ocl-icd-opencl-dev opencl-headers opencl-clhpp-headers pocl-opencl-icd"  # PoCL: OpenCL on the CPU
tests="doctest-dev mandoc"                                              # make test
demo="gnuplot-nox"                                                      # the plot of make demo
packages="$build $libraries $opencl $tests $demo"

if ! command -v dpkg-query > /dev/null || ! command -v apt-get > /dev/null; then
    echo "setup: no apt-get here; please see to it that these (Debian's names) are installed: $packages" >&2
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

echo "setup: installing with apt-get:$missing" >&2
$sudo apt-get update -q
# shellcheck disable=SC2086  # the list is meant to be split
$sudo env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing
