#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# make.sh SIZE FRAMES: measures again what is older than lib (CIE 171: or than the study) by the commit in its table,
# and writes docs/certificate.md and .html.  BIN: the folder of the programs.
set -euo pipefail
cd "$(dirname "$0")/../.."
study=studies/cie171 table=studies/cie171/results.tsv
last=$(sed -n 's/^# commit\t//p' $table 2> /dev/null || true)
if [ -n "$last" ] &&
    git diff --quiet "$last" -- lib $study/{skies,cases,lamps,conservation,variants,run}.py 2> /dev/null; then
    echo "$table: newer than lib"
else
    python3 -B $study/reference.py > $study/reference.new && mv $study/reference.new $study/reference.tsv
    # values that are wrong stay in the table and on the page
    python3 -B $study/run.py -bin "$BIN" -size "$1" -frames "$2" > $table.new || echo "$table: values are wrong"
    mv $table.new $table
fi
faults=studies/certificate/mutations.tsv
last=$(sed -n 's/^# commit\t//p' $faults 2> /dev/null || true)
if [ -n "$last" ] && git diff --quiet "$last" -- lib studies/certificate/mutations.py 2> /dev/null; then
    echo "$faults: newer than lib"
else
    python3 -B studies/certificate/mutations.py > $faults.new && mv $faults.new $faults
fi
python3 -B studies/certificate/measure.py -bin "$BIN"
python3 -B studies/certificate/page.py
