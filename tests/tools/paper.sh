# SPDX-License-Identifier: BSD-3-Clause
# The study of the paper, small: a table and a page, and a run that goes on where another one stopped.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcregion vcmetrics make python3
mkdir -p studies examples
cp -r "$TOP/studies/paper" studies && cp -r "$TOP/examples/scenes" examples
cd studies/paper || exit 2
study() { make "BIN=$BIN" SIZE=24 SCENES=blinds "$@"; }

check 'the study makes a table of claims and a page' '
    study STAGES="0 1 4 9" OUT=whole > log
    grep -q "^DGP at frame 10.*within 5 %" whole/claims.tsv; grep -q "frames of these runs.10000.9" whole/claims.tsv
    [ "$(cut -f 1 whole/blinds/metrics.tsv | tr "\n" " ")" = "frame 0 1 2 3 4 5 6 7 8 9 " ]
    grep -q "blinds/4.png" whole/figures.html; test -s whole/blinds/4.png'
check 'a second make does nothing' 'study STAGES="0 1 4 9" OUT=whole | grep -q "Nothing to be done"'
check 'a run that stopped early goes on to the same sum' '
    study STAGES="0 1 4" OUT=part > log; study STAGES="0 1 4 9" OUT=part > log2; [ "$(grep -c "^ptrace" log2)" = 1 ]
    cut -f 1,3- part/blinds/metrics.tsv > a; cut -f 1,3- whole/blinds/metrics.tsv > b; cmp a b'
check 'regions have the sizes of the paper' '
    bash regions.sh 512 > r; grep -q "^desk rect 209 144 303 204$" r; grep -q "^low rect 224 242 232 246$" r'
