# SPDX-License-Identifier: BSD-3-Clause
# README.md shows what the commands give: its picture is the demo's, its lines are those of its pipe.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics
picture=$TOP/$(sed -n 's/^!\[.*\](\(.*\))$/\1/p' "$TOP/README.md" | head -n 1)
awk '/^```/ { n += !on; on = !on; next } on { print > ("block." n) }' "$TOP/README.md"  # 1: the pipe, 2: its lines
demos() { sed -n '/^ptrace/s/ |$//p' "$TOP/examples/demo.sh" | tr -d '"'; }

check 'the picture is what the demo renders, filtered, and small' '
    [ "$(wc -c < "$picture")" -lt 200000 ]; grep -aq "^FILTERED= non-local means" "$picture"
    size=$(grep -a "^ptrace " "$picture" | sed -n "s/.* -x \([0-9]*\) .*/\1/p")
    grep -aqxF "$(demos | sed "s/\$size/$size/g")" "$picture"'
cp "$TOP"/examples/scenes/office/* .
sed -i 's, 128, 32,g' block.1
timeout 200 bash -eo pipefail block.1 > lines 2> said
forms() { sed -E 's/[0-9.]+/N/g; s/[^\t]*$/TAILS/' "$@"; }
check 'its pipe prints such lines, and stops' '
    grep -q "^vcmetrics: stopped after" said
    diff <(head -n 1 lines) <(head -n 1 block.2); diff <(tail -n 5 lines | forms) <(tail -n 5 block.2 | forms)'
check 'with such numbers' '
    { tail -n 1 lines; tail -n 1 block.2; } |
        awk "{ ev[NR] = \$3; dgp[NR] = \$6 }
            END { exit !((ev[1] / ev[2] - 1)^2 < .03^2 && (dgp[1] - dgp[2])^2 < .02^2) }"'
check 'its make goals are there' '
    for goal in $(sed -n "s/^make \([a-z]*\) .*/\1/p" "$TOP/README.md"); do grep -q "^$goal:" "$TOP/Makefile"; done'

mkdir few && for program in bash cut date dirname ls mkdir tail tee; do ln -s "$(command -v $program)" few; done
check 'the demo ends well where there is no gnuplot for its plot' '
    PATH=$BIN:$TMP/few SIZE=16 UNTIL="Ev 20%" bash "$TOP/examples/demo.sh" "$BIN" out > said
    [ "$(tail -n 1 said)" = regions.exr ]'
