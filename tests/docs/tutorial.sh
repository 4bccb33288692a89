# SPDX-License-Identifier: BSD-3-Clause
# Every command of docs/tutorial.md runs, one block after another in one shell, only smaller: 512 and 256 become 24.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics
mkdir -p build && ln -s "$BIN" build/bin && cp -r "$TOP/examples" .

awk '/^```sh$/ { n++; on = 1; next } /^```$/ { on = 0 } on { print > ("block." n) }' "$TOP/docs/tutorial.md"
blocks=$(ls block.* | sort -t . -k 2n | sed "s|^|$PWD/|")
sed -i -E 's/-([xy]) (512|256)/-\1 24/g' $blocks
cat > session << 'END'
set -eo pipefail
for block; do
    . "$block" > "$block.said" 2> "$block.errors" || { cat "$block.errors"; exit 1; }
    ! grep -v 'stopped after' "$block.errors" || exit 1
done >&2
END
check 'every command runs, without a warning' 'bash session $blocks'
said() { cat $(grep -l -e "$1" block.? block.?? | tail -n 1).said; }

check 'names of materials are those that the page shows' '
    grep -E "^ +[0-9]+ usemtl " "$TOP/docs/tutorial.md" > want; said "uniq -c" | diff - want'
check 'the answer is that of the page: intolerable, known within .01' '
    said desk.tsv | tail -n 1 |
        awk "{ exit !(\$6 - \$5 <= .02 && \$4 > .45 && \$7 == \"intolerable\") }"'
check 'sources are listed by their share of glare' '
    said "[-]sources" | awk "NR > 1 && \$15 > last { bad = 1 } { last = \$15 } END { exit bad || NR < 3 }"'
check 'the hours have a row each' '
    [ "$(said "[-]sky sky_10" | cut -f 3 | tr "\n" " ")" = "sky sky_10 sky_12 sky_14 sky_16 " ]'
check 'and the Honeybee room one' '
    said "[-]metrics Ev,DGPf,classf hb.exr" | grep -qE "^hb.exr.[0-9.]+.0[.][0-9]+.[a-z]+$"'
