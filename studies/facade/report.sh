#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# report.sh OUT: one page of OUT/table.tsv: DGPf by hour in its classes, and the pictures in falsecolor, worst first.
set -euo pipefail
cd "$1"
for picture in *_*_*_*.exr; do
    [ "${picture%.exr}.png" -nt "$picture" ] ||
        ptaccum "$picture" -o "${picture%.exr}.png" -tone falsecolor -nolegend -max 5000 -decades 3
done

# Classes of daylight glare probability: imperceptible below .35, perceptible, disturbing from .40,
# intolerable from .45.
classes='function class(dgp) {
    return dgp < .35 ? "ok" : dgp < .40 ? "seen" : dgp < .45 ? "bad" : "worst"
}'
{
    cat << 'HEAD'
<!DOCTYPE html><html lang="en"><meta charset="utf-8"><title>Facade study</title>
<style>
body { font: 14px sans-serif; margin: 2em } td, th { padding: 3px 8px; text-align: right }
.ok { background: #d8f0d8 } .seen { background: #fff3b8 } .bad { background: #ffd2a0 } .worst { background: #f4a8a8 }
figure { display: inline-block; margin: 4px; text-align: center } figcaption { font-size: 12px }
</style>
<h1>Daylight glare probability by hour</h1>
<p><span class="ok">below .35 imperceptible</span> <span class="seen">from .35 perceptible</span>
<span class="bad">from .40 disturbing</span> <span class="worst">from .45 intolerable</span></p>
<table>
HEAD
    tail -n +2 table.tsv | sort -t "$(printf '\t')" -k1,1 -k2,2n -k3,3 -k4,4 | awk -F '\t' "$classes"'
        { row = $1 ", blind " $2 ", " $3; if (!(row in seen)) { seen[row] = 1; rows[++n] = row }
          if (!($4 in hour)) { hour[$4] = 1; hours[++m] = $4 } value[row, $4] = $8 }
        END { printf "<tr><th>"; for (k = 1; k <= m; k++) printf "<th>%s", hours[k]; print ""
              for (r = 1; r <= n; r++) {
                  printf "<tr><th>%s", rows[r]
                  for (k = 1; k <= m; k++) { v = value[rows[r], hours[k]]; printf "<td class=%s>%.2f", class(v), v }
                  print "" } }'
    echo '</table><h1>Luminance, worst first</h1>'
    tail -n +2 table.tsv | sort -t "$(printf '\t')" -k8,8gr | awk -F '\t' "$classes"'
        { name = $1 "_" $2 "_" $3 "_" $4
          printf "<figure class=%s><img src=\"%s.png\" width=96 height=96 alt=\"%s\">", class($8), name, name
          printf "<figcaption>%s %s&deg; %s %s h<br>", $1, $2, $3, $4
          printf "DGP %.3f (%.3f to %.3f), %.0f lx</figcaption></figure>\n", $8, $9, $10, $5 }'
} > report.part
mv report.part report.html
