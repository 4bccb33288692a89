#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# sanitize.sh [JOBS]: every test under the address and undefined-behaviour sanitizers, which also report floats cast to
# integers that cannot hold them (build-asan), then what has threads under the thread sanitizer (build-tsan).  A report
# ends its program with status 99, and so fails its test.
# Libraries that are not built with a sanitizer are taken at their word: tests/sanitizers/*.supp says which.
set -eu
cd "$(dirname "$0")/.."
jobs=${1:-$(nproc)}
supp=$PWD/tests/sanitizers
export ASAN_OPTIONS=exitcode=99:detect_stack_use_after_return=1:allocator_may_return_null=1
export LSAN_OPTIONS=suppressions=$supp/leak.supp:print_suppressions=0
export UBSAN_OPTIONS=print_stacktrace=1
export TSAN_OPTIONS=exitcode=99:suppressions=$supp/thread.supp:second_deadlock_stack=1
threaded='^(ptrace_|render_control|live$|luxpipe_live|vcview_|pipeline|every_primitive|frame|instances_test'
threaded="$threaded|closed_forms_test|break_scenes|break_kills)"

try() {  # folder, sanitizers, which tests
    cmake -S . -B "$1" -G Ninja --log-level=WARNING -DCMAKE_CXX_FLAGS_RELEASE=-O1 \
        -DLUXPIPE_SANITIZE="$2" > /dev/null
    cmake --build "$1" -j "$jobs"
    (cd "$1" && shift 2 && ctest --output-on-failure -j "$jobs" -LE 'gpu|slow|slurm' --timeout 3000 "$@")
}

try build-asan address,undefined,float-cast-overflow
try build-tsan thread -R "$threaded"
