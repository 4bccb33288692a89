#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# test_windows.sh BUILD: the programs for Windows that were built in BUILD, under wine: evalglare's recorded runs, and
# files beside those of this machine's programs ($BIN).  Wine is not Windows: its files, pipes and console are Linux's.
set -eu
top=$(cd "$(dirname "$0")/.." && pwd)
build=$(cd "$1" && pwd)
BIN=$(cd "${BIN:?}" && pwd)
export WINEPREFIX=$build/wine WINEDEBUG=-all WINDOWS=$build/bin
mkdir -p "$WINEPREFIX"
wineserver -p  # one server for all runs
trap 'wineserver -k' EXIT
printf '#!/bin/sh\nexec wine "%s" "$@"\n' "$build/bin/vcmetrics.exe" > "$build/vcmetrics"
chmod +x "$build/vcmetrics"
status=0
bash "$top/scripts/golden_runs.sh" "$build/vcmetrics" -DOTHER_PROCESSOR || status=1
TOP=$top BIN=$BIN bash "$top/tests/tools/windows.sh" || status=1
exit $status
