# SPDX-License-Identifier: BSD-3-Clause
# A year cut into shares of its hours (examples/cluster, studies/year), small: interrupted, resumed, joined.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcyear make python3
mkdir studies
cp -r "$TOP/examples" . && cp -r "$TOP/studies/year" studies
python3 studies/year/weather.py > site.epw
export WEATHER=$PWD/site.epw HOURS='0320-0323 9-12' SIZE=16 FRAMES=4

check 'shares of hours are joined to the year of one run' '
    bash examples/cluster/hours.sh 0 1 whole 2> said; vcyear whole/0.tsv > expected
    grep -q "^hours     12, 0 dark" expected
    for k in 0 1 2; do bash examples/cluster/hours.sh $k 3 parts 2> said; done
    cat parts/*.tsv | vcyear - | cmp - expected
    cat parts/*.tsv | grep -v ^frame > lines; tail -n +2 whole/0.tsv | cmp - lines'
check 'a share that was stopped leaves no table and is made again, alone' '
    mkdir broken; printf "#!/bin/bash\n$BIN/ptrace \"\$@\" | head -c 20000; exit 9\n" > broken/ptrace
    chmod +x broken/ptrace
    rm parts/1.tsv; touch -d 2000-01-01 parts/0.tsv
    PATH=$PWD/broken:$PATH not bash examples/cluster/hours.sh 1 3 parts 2> said
    not test -e parts/1.tsv
    for k in 0 1 2; do bash examples/cluster/hours.sh $k 3 parts 2> said; done
    [ -z "$(find parts/0.tsv -newermt 2001-01-01)" ]; cat parts/*.tsv | vcyear - | cmp - expected'
check 'rounds of larger pictures decide the class, whatever the order of their tables' '
    SIZE=16 bash examples/year.sh rounds site.epw 0201_1530 8 > rounds.txt 2> said
    vcyear rounds/0.tsv | grep -q "EN 17037 undecided"; grep -q "^round 1: 1 hours, " rounds.txt
    grep -v ^round rounds.txt > last; grep -qE "EN 17037 (high|medium|minimum|none)$" last
    vcyear $(ls -r rounds/*.tsv) | cmp - last; [ "$(vcyear -next rounds/*.tsv | wc -l)" = 1 ]'
cd studies/year || exit 2
study() {
    make -s "BIN=$BIN" "OUT=$TMP/out" HOURS='0320-0321 9-12' SHARES=2 SIZE=16 FRAMES=4 "WEATHER=$WEATHER" 2> "$TMP/said"
}
check 'the study has a page with classes, plan, worst hours and heat maps' '
    study > five; [ "$(grep -c "^DGPe5" five)" = 4 ]; grep -q "^all 4 views: sGA" five
    page=$TMP/out/year.html; grep -q "<td>window</td><td class=" $page; grep -q "of 2 days<" $page
    [ "$(grep -o "<figure id=.v[0-3]_032[01]_[01][0-9]30" $page | wc -l)" = 4 ]
    [ "$(grep -c "<g class=.arrow" $page)" = 4 ]'
check 'a second make renders nothing; a share that is gone is made again' '
    touch -r "$TMP/out/hours.1.tsv" then; study > again; [ ! -s again ]
    rm "$TMP/out/hours.2.tsv"; study > again; test -s "$TMP/out/hours.2.tsv"
    not [ "$TMP/out/hours.1.tsv" -nt then ]; [ -s again ]'
