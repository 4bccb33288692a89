#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# make.sh SIZE FRAMES: measures again what is older than lib (CIE 171: or than the study) by the commit in its table,
# and writes docs/certificate.md and .html.  BIN: the folder of the programs.
set -euo pipefail
cd "$(dirname "$0")/../.."
study=studies/cie171 table=studies/cie171/results.tsv
is_new() {  # TABLE FILE...: nothing of lib and these files has changed since the commit in the table
    local last
    last=$(sed -n 's/^# commit\t//p' "$1" 2> /dev/null || true)
    [ -n "$last" ] && git diff --quiet "$last" -- lib "${@:2}" 2> /dev/null && echo "$1: newer than lib"
}
if ! is_new $table $study/{skies,cases,lamps,conservation,variants,run}.py; then
    python3 -B $study/reference.py > $study/reference.new && mv $study/reference.new $study/reference.tsv
    # values that are wrong stay in the table and on the page
    python3 -B $study/run.py -bin "$BIN" -size "$1" -frames "$2" > $table.new || echo "$table: values are wrong"
    mv $table.new $table
fi
faults=studies/certificate/mutations.tsv widths=studies/certificate/widths.tsv
if ! is_new $faults studies/certificate/mutations.py; then
    python3 -B studies/certificate/mutations.py > $faults.new && mv $faults.new $faults
fi
if ! is_new $widths studies/certificate/widths.py; then
    python3 -B studies/certificate/widths.py -bin "$BIN" > $widths.new && mv $widths.new $widths
fi
python3 -B studies/certificate/measure.py -bin "$BIN"
python3 -B studies/certificate/page.py
