#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# run.sh BIN OUT SECONDS [target ...]: runs each fuzz target from its seeds and from what OUT/corpus kept of earlier
# runs.  Prints a line for each target: seconds, runs, finds.  The inputs that were found stay in OUT.
set -u
here=$(cd "$(dirname "$0")" && pwd)
bin=$(cd "$1" && pwd) && mkdir -p "$2" && out=$(cd "$2" && pwd) && seconds=$3 && shift 3
[ $# -gt 0 ] || set -- $(sed -n 's/^ *lux_fuzz(\([a-z_]*\) .*/\1/p' "$here/CMakeLists.txt")
status=0
for target; do
    mkdir -p "$out/corpus/$target"
    seeds=("$here/seeds/$target")
    [ "$target" != scene_render ] || seeds+=("$here/seeds/scene_rad" "$here/../golden/vectors")
    begun=$SECONDS
    "$bin/fuzz_$target" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=3000 -max_len=16384 \
            -artifact_prefix="$out/$target." \
        "$out/corpus/$target" "${seeds[@]}" > "$out/$target.log" 2>&1 || status=1
    printf '%s\t%d s\t%s runs\t%d finds\n' "$target" $((SECONDS - begun)) \
        "$(sed -n 's/^Done \([0-9]*\) runs.*/\1/p' "$out/$target.log")" "$(grep -c '^SUMMARY' "$out/$target.log")"
done
exit $status
