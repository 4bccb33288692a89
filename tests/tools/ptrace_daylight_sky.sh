# SPDX-License-Identifier: BSD-3-Clause
# ptrace -daylight sky: the temperature of skies without a spectrum, from how clear they are.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics
halves='skyfunc glow sky_glow 0 0 4 1 1 1 0\nsky_glow source sky 0 0 4 0 0 1 180
skyfunc glow ground_glow 0 0 4 1 1 1 0\nground_glow source ground 0 0 4 0 0 -1 180\n'
printf "!gensky -ang 40 0 -c -B 70\n$halves" > cloudy.rad
printf "!gendaylit -ang 40 0 -L 80000 12000\n$halves" > clear.rad
printf 'void plastic p 0 0 5 .5 .5 .5 0 0\np ring floor 0 0 8 0 0 -.1 0 0 1 0 9\n' > grey.rad
printf '0 0 1 0 -1 0\n0 0 1 0 1 0\n' > eyes.pts  # towards the sun, and away from it
ratios() {  # ptrace's arguments: of each point and hour the melanopic illuminance over that by V
    ptrace -points eyes.pts -action mel -action V -bands 3 -frames 9 "$@" grey.rad 2> said | ptaccum -every x2/8 |
        vcmetrics -last -each -metrics mEDI,EvV | awk -F "\t" '
        NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
        { e = $at["EvV"]; print (e ? $at["mEDI"]/e : "dark") }'
}
near() { awk -v by="$1" '!(($1 - $2)^2 < by^2) { bad = 1 } END { exit !NR || bad }'; }

check 'an overcast sky has 6191 K, and the line says why' '
    ratios -daylight sky cloudy.rad > sky
    grep -qx "ptrace: -daylight sky: a sky of 6191 K (12[0-9]* lx, taken for overcast, as there is no sun)" said
    not grep glow said
    ratios -daylight 6191 cloudy.rad | paste sky - | near 1e-4'
check 'a clear one is bluer than its sun' '
    ratios -daylight sky clear.rad > sky
    grep -Eq "sky: a sky of (99|100)[0-9]{2} K \(1[12][0-9]+ lx, clearness [45].[0-9]; a sun at 40 degrees\)" said
    awk "{ r[NR] = \$1 } END { exit !(r[1] > .9 && r[1] < .95 && r[2] > r[1] + .03 && r[2] < 1.1) }" sky'
check 'a lamp that is named keeps its own' '
    ratios -daylight sky -lamp sky_glow=A -lamp ground_glow=A cloudy.rad > named; not grep "is no light" said
    awk "!(\$1 > .49 && \$1 < .5) { bad = 1 } END { exit NR != 2 || bad }" named'
check 'hours that share their paths have the ratios of those that do not' '
    printf "place x\nlatitude 39.74\nlongitude 105.18\ntime_zone 105\nsite_elevation 1829\n" > y.wea
    printf "weather_data_file_units 1\n6 21 5.5 0 0\n6 21 8.5 300 190\n" >> y.wea
    printf "6 21 12.5 700 90\n12 21 12.5 0 30\n" >> y.wea
    ratios -daylight sky -wea y.wea > together
    grep -qx "ptrace: -daylight sky: skies of 6191 to [0-9]* K" said; [ "$(grep -c daylight said)" = 1 ]
    ratios -daylight sky -wea y.wea -hours-apart | paste together - | tee both | near .01
    [ "$(grep -c dark together)" = 2 ] && [ "$(sort -u together | wc -l)" -ge 5 ]'
check 'a mirrored sun has its own' '
    printf "void mirror m 0 0 3 .9 .9 .9\nm polygon wall 0 0 12 -3 3 0 3 3 0 3 3 6 -3 3 6\n" > mirror.rad
    printf "void plastic m 0 0 5 .9 .9 .9 1 0\nm polygon wall 0 0 12 -3 3 0 3 3 0 3 3 6 -3 3 6\n" > metal.rad
    ratios -daylight sky -wea y.wea metal.rad | tail -n +3 > together
    ratios -daylight sky -wea y.wea -hours-apart metal.rad | tail -n +3 | paste together - | near .015'
check 'where there is neither sun nor sky it is said' '
    printf "void light l 0 0 3 9 9 9\nl sphere bulb 0 0 4 0 0 3 .2\n" | ratios -daylight sky - > none
    grep -qx "ptrace: warning: -daylight: the scene has no sun and no sky" said'
