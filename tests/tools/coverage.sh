# SPDX-License-Identifier: BSD-3-Clause
# The short draw of studies/coverage: 95 % intervals of three rooms that nobody designed, fixed seeds, 32 x 32 pixels.
# tests/golden/coverage.tsv has the truth: 32 other seeds of 256 frames each.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics python3
check 'intervals of short runs hold the truth, 95 % less three standard deviations' \
    'python3 -B "$TOP/studies/coverage/coverage.py" -bin "$BIN" -out . -scenes 2000-2002 -seeds 16 -size 32 -frames 25 \
         -truth "$TOP/tests/golden/coverage.tsv" -do trace,measure,check >&2'
