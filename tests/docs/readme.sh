# SPDX-License-Identifier: BSD-3-Clause
# README.md shows what the commands give: its picture is the demo's, its lines are those of its pipe.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics
picture=$TOP/$(sed -n 's/^!\[.*\](\(.*\))$/\1/p' "$TOP/README.md" | head -n 1)
blocks() {  # PAGE: the blocks of a page that begin with these words, in files of that name
    awk '/^```/ { on = !on; begins = on; next }
         begins { file = $1 ~ /^(ptrace|frame|cmake|apt)$/ ? "block." $1 : "block.other"; begins = 0 }
         on { print > file }' "$1"
}
blocks "$TOP/README.md"
demos() { sed -n '/^ptrace/s/ |$//p' "$TOP/examples/demo.sh" | tr -d '"'; }

check 'the picture is what the demo renders, filtered, and small' '
    [ "$(wc -c < "$picture")" -lt 200000 ]; grep -aq "^FILTERED= non-local means" "$picture"
    size=$(grep -a "^ptrace " "$picture" | sed -n "s/.* -x \([0-9]*\) .*/\1/p")
    grep -aqxF "$(demos | sed "s/\$size/$size/g")" "$picture"'
cp "$TOP"/examples/scenes/office/* .
sed -i 's, 128, 32,g' block.ptrace
timeout 200 bash -eo pipefail block.ptrace > lines 2> said
forms() { sed -E 's/[0-9.]+/N/g; s/[^\t]*$/TAILS/' "$@"; }
check 'its pipe prints such lines, and stops' '
    grep -q "^vcmetrics: stopped after" said
    diff <(head -n 1 lines) <(head -n 1 block.frame); diff <(tail -n 2 lines | forms) <(tail -n 2 block.frame | forms)'
check 'with such numbers' '
    { tail -n 1 lines; tail -n 1 block.frame; } |
        awk "{ ev[NR] = \$3; dgp[NR] = \$6 }
            END { exit !((ev[1] / ev[2] - 1)^2 < .03^2 && (dgp[1] - dgp[2])^2 < .02^2) }"'
words() { tr -s ' \n\\' '\n' | sed '/^$/d' | sort; }
check 'its packages are those of scripts/setup.sh, doctest and clang' '
    sed -n "1,/^cmake/s/^cmake.*//; s/^apt install//p; /^    /p" block.apt | words > listed
    { sed -n "/^ *tools)/,/;;/p; /^ *ptrace)/p" "$TOP/scripts/setup.sh" | sed "s/.*\$packages//; s/\".*//"
      echo doctest-dev clang; } | words | diff - listed'
check 'its make goals are there' '
    for goal in $(sed -n "s/^make \([a-z]*\) .*/\1/p" "$TOP/README.md"); do grep -q "^$goal:" "$TOP/Makefile"; done'

mkdir few && for program in bash cut date dirname ls mkdir tail tee; do ln -s "$(command -v $program)" few; done
check 'the demo ends well where there is no gnuplot for its plot' '
    PATH=$BIN:$TMP/few SIZE=16 UNTIL="Ev 20%" bash "$TOP/examples/demo.sh" "$BIN" out > said
    [ "$(tail -n 1 said)" = regions.exr ]'
