#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# golden_runs.sh VCMETRICS FLAGS...: evalglare's recorded runs by a vcmetrics that another compiler, processor or system
# made.  The test is this machine's, the program that it calls is not.  FLAGS are the compiler's (-DOTHER_PROCESSOR).
set -eu
top=$(cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"${CXX:-g++}" -std=c++17 -O1 -pthread "-DLUXPIPE_TESTS=\"$top/tests\"" "-DVCMETRICS=\"$(realpath "$1")\"" "${@:2}" \
    "$top/tests/parity/evalglare_golden_test.cpp" -o "$work/test"
"$work/test"
