#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# table.sh desk_35_sunny_09.tsv ...: one table whose rows say view, blind angle, sky and hour, for standard output.
set -euo pipefail
awk -F '\t' -v OFS='\t' '
    FNR == 1 && NR == 1 { $1 = "view" OFS "blind" OFS "sky" OFS "hour"; print }
    FNR > 1 { n = split(FILENAME, path, "/"); sub(/[.]tsv$/, "", path[n]); split(path[n], of, "_")
              $1 = of[1] OFS of[2] OFS of[3] OFS of[4]; print }' "$@"
