#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# test_arm64.sh BUILD [all]: the tests of programs for ARM (aarch64) that were built in BUILD on another processor,
# under qemu: the same bits as everywhere, closed forms, evalglare's recorded runs (each picture and each list of
# arguments once, or all), shell tests, some of Python's.  An emulator is no machine: speed, the order of threads'
# memory and the system below are this machine's.  `test_arm64.sh targets` prints what is built besides the programs.
set -u
tests='base_test kernels_math_test kernels_sampler_test image_rgbe_test film_exact_sum_test closed_forms_test'
[ "$1" != targets ] || { echo "$tests bits_test mkstream"; exit 0; }
top=$(cd "$(dirname "$0")/.." && pwd)
build=$(cd "$1" && pwd)
failed=()
# no driver of OpenCL: this machine's are for its own processor
export OCL_ICD_VENDORS=$build/no_drivers

# try NAME COMMAND...: one line for each test, its output where it fails.
try() {
    local name=$1 start=$SECONDS status
    shift
    "$@" > "$build/$name.log" 2>&1
    status=$?
    case $status in
        0) word=passed ;;
        77) word=skipped ;;
        *) word=FAILED; failed+=("$name"); grep -vE '^(ok|[|]) ' "$build/$name.log" | tail -n 30 ;;
    esac
    printf '%-24s %s %5d s  %s\n' "$name" "$word" $((SECONDS - start)) \
        "$(grep -E '^(\[doctest\] assertions|[0-9]+ of [0-9]+)|rows' "$build/$name.log" | tail -n 1)"
}

# the programs as others find them in PATH: each is called by qemu
mkdir -p "$build/run"
for program in "$build"/bin/*; do
    name=$(basename "$program")
    if [ "$(head -c 4 "$program" | tail -c 3)" = ELF ]; then
        printf '#!/bin/sh\nexec qemu-aarch64-static -0 %s -L "%s" "%s" "$@"\n' "$name" "$build/root" "$program" \
            > "$build/run/$name"
        chmod +x "$build/run/$name"
    else
        cp "$program" "$build/run/$name"
    fi
done

for test in $tests; do
    try "$test" "$build/run/$test"
done
[ "${2:-}" = all ] && rows=() || rows=(-DEACH_ONCE)
try evalglare_golden bash "$top/scripts/golden_runs.sh" "$build/run/vcmetrics" -DOTHER_PROCESSOR "${rows[@]}"
# small ones: qemu takes 80 times the time
export side=24 PYTEST_ADDOPTS="-k 'saved_pictures or test_measure or not_converged or pyradiance_names or arrays_need'"
for test in ptaccum_test vcmetrics_test vcregion_test vcyear_test pipeline ptrace_options inputs python; do
    try "$test" env TOP="$top" BIN="$build/run" bash "$top/tests/tools/$test.sh"
done
try bits "$build/run/bits_test" cpu

[ ${#failed[@]} -eq 0 ] || { echo "test-arm64: these failed: ${failed[*]}" >&2; exit 1; }
