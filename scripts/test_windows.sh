#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# test_windows.sh BUILD: tests the programs for Windows in BUILD under wine.  They must repeat evalglare's recorded
# runs, give the recorded bits of frames, and write the files that this machine's programs ($BIN) write.
# Wine is not Windows: its files, pipes and console are Linux's.
set -eu
top=$(cd "$(dirname "$0")/.." && pwd)
build=$(cd "$1" && pwd)
BIN=$(cd "${BIN:?}" && pwd)
export WINEPREFIX=$build/wine WINEDEBUG=-all WINDOWS=$build/bin
mkdir -p "$WINEPREFIX"
wineserver -p  # one server for all runs
trap 'wineserver -k' EXIT
printf '#!/bin/sh\nexec wine "%s" "$@"\n' "$build/bin/vcmetrics.exe" > "$build/vcmetrics"
printf '#!/bin/sh\nRAYPATH=$(echo "$RAYPATH" | tr : ";") exec wine "%s" "$@"\n' "$build/bin/ptrace.exe" \
    > "$build/ptrace"
chmod +x "$build/vcmetrics" "$build/ptrace"
status=0
bash "$top/scripts/golden_runs.sh" "$build/vcmetrics" -DOTHER_PROCESSOR || status=1
python3 "$top/tests/parity/bits_frames.py" "$build" "$top" cpu:baseline cpu:avx2 || status=1
TOP=$top BIN=$BIN bash "$top/tests/tools/windows.sh" || status=1
exit $status
