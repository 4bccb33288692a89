#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Eight shares by GNU parallel, here or on the hosts of a file (one a line, ":" is this one; they see this folder):
#     bash parallel.sh [--sshloginfile hosts]
# --joblog and --resume-failed: what was done before an interruption is not done again.
set -euo pipefail
cd "$(dirname "$0")"
out=${OUT:-out}
mkdir -p "$out"
parallel --jobs "${JOBS:-1}" --joblog "$out/log" --resume-failed --env PATH --env SIZE --env FRAMES \
    --workdir "$PWD" "$@" bash share.sh {} 8 "$out" ::: 0 1 2 3 4 5 6 7
ptaccum "$out"/[0-7].exr -o "$out/whole.exr"
