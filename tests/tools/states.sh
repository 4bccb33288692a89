# SPDX-License-Identifier: BSD-3-Clause
# States of blinds (ptrace -state): each is the picture of a run of its own, and says its name down to the tables.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcyear mkstream
printf 'void glow sky 0 0 4 1 1 1 0\nsky source s 0 0 4 0 0 1 180\n' > sky.rad
printf 'void plastic p 0 0 5 .5 .5 .5 0 0\np ring floor 0 0 8 0 0 0 0 0 1 0 9\n' > room.rad
printf 'void plastic q 0 0 5 0 0 0 0 0\nq ring roof 0 0 8 0 0 2 0 0 1 0 3\n' > roof.rad
printf 'void plastic r 0 0 5 0 0 0 0 0\nr ring roof 0 0 8 0 0 2 0 0 1 0 900\n' > 'vast roof.rad'
printf '0 0 1 0 0 1\n0 0 1 0 0 -1\n' > desk.pts
view='-vta -vp 0 0 1 -vd 0 0 1 -vu 0 1 0 -vv 180 -vh 180 -x 8 -y 8'
states=(-state open -state half=roof.rad -state "shut=-sky.rad +sky.rad +'vast roof.rad'")

check 'a picture of each state, with its name' '
    ptrace $view -frames 3 "${states[@]}" sky.rad room.rad > all.str
    [ "$(strings all.str | sed -n "s/^STATE=//p" | uniq | tr "\n" " ")" = "open half shut " ]'
check 'with the frames of a run for this scene alone' '
    ptaccum -o "%s.exr" < all.str
    ptrace $view -frames 3 sky.rad room.rad roof.rad | ptaccum -last -o alone.exr
    [ "$(mkstream differ alone.exr half.exr)" = 0 ]; [ "$(mkstream differ open.exr half.exr)" -gt 0 ]'
check 'tables have a column for it' '
    ptaccum -every x2 < all.str | vcmetrics -W- -metrics Ev -ci 95 -last > rows
    [ "$(cut -f 3 rows | tr "\n" " ")" = "state open half shut " ]
    awk -F "\t" "NR == 2 { if (\$4 < 500) exit 1 } NR == 4 { if (\$4 > .001) exit 1 }" rows'
check 'and those of sensors, which begin anew with each state' '
    ptrace -points desk.pts -frames 5 "${states[@]}" sky.rad room.rad | ptaccum -every x2 | vcmetrics -W- -each > rows
    [ "$(cut -f 1,3 rows | tr "\t\n" "/ ")" = "state/point open/0 open/1 half/0 half/1 shut/0 shut/1 " ]'
check 'groups are combined, which is told, and files have their names' '
    ptrace $view -picture -frames 2 -o "p_%s.hdr" -state s/open -state s/shut=roof.rad -state w/open \
        -state w/shut="vast\ roof.rad" sky.rad room.rad 2> said
    grep -qx "ptrace: 4 states: those of the groups combined" said
    ls p_s-open+w-open.hdr p_s-open+w-shut.hdr p_s-shut+w-open.hdr p_s-shut+w-shut.hdr
    strings p_s-shut+w-open.hdr | grep -qx "STATE=s/shut+w/open"'
check 'a generator may stand behind !' '
    ptrace $view -frames 2 -state "box=!genbox p b 1 1 1" sky.rad room.rad | ptaccum -last -o %s.exr'
check_error 'any other command needs -exec' 1 '^ptrace: command line' '
    ptrace $view -frames 2 -state "box=!ls roof.rad" sky.rad room.rad > out.str'
check 'the rule of make names the files of all states' '
    ptrace -M x "${states[@]}" sky.rad room.rad | tr -d "\\\\\n" > rule
    grep -q "[^t] roof.rad" rule; grep -q "vast roof.rad" rule; [ "$(grep -o x: rule | wc -l)" = 1 ]'
check 'hours share their paths in each state' '
    printf "place Here\nlatitude 39.74\nlongitude 105.18\ntime_zone 105\nsite_elevation 1829\n" > y.wea
    printf "weather_data_file_units 1\n6 21 5.5 0 0\n6 21 12.5 700 90\n6 21 13.5 700 90\n" >> y.wea
    ptrace -w- -points desk.pts -wea y.wea -frames 3 -state open -state half=roof.rad room.rad 2> said |
        ptaccum -every x2 | vcmetrics -W- -each > rows
    hours() { printf " 2 0621_%s $1" 0530 1230 1330; }
    [ "$(sed 1d rows | cut -f 1,2 | uniq -c | tr -s " \t\n" " ")" = "$(hours open; hours half) " ]
    [ "$(grep 1230 rows | cut -f 9 | sort -u | wc -l)" = 2 ]'
check 'the groups of a Honeybee folder with all their states, in the place of the first one' '
    mkdir -p "m/model/scene" m/model/aperture_group m/model/scene_dynamic; cp sky.rad room.rad m/model/scene
    cp roof.rad m/model/aperture_group/s..default..0.rad; cp "vast roof.rad" m/model/aperture_group/s..default..1.rad
    cp roof.rad m/model/aperture_group/s..blk.rad
    printf "# none\n" > m/model/scene_dynamic/t..default..0.rad
    ptrace $view -frames 3 -honeybee-states m/model 2> said > groups.str
    [ "$(strings groups.str | sed -n "s/^STATE=//p" | uniq | tr "\n" " ")" = "s/0+t/0 s/1+t/0 " ]
    ptaccum -o "hb_%s.exr" < groups.str
    ptrace $view -frames 3 m/model | ptaccum -last -o alone.exr
    [ "$(mkstream differ alone.exr hb_s-0+t-0.exr)" = 0 ]
    ptrace $view -frames 3 sky.rad room.rad "vast roof.rad" | ptaccum -last -o alone.exr
    [ "$(mkstream differ alone.exr hb_s-1+t-0.exr)" = 0 ]'
check_error 'and of no other scene' 1 '^ptrace: -honeybee-states: the scene has no aperture group and no' '
    ptrace $view -frames 2 -honeybee-states sky.rad room.rad | cat'
check_error 'edits are of one state' 1 '^ptrace: -state: edits are of one state' '
    ptrace $view -watch "${states[@]}" sky.rad room.rad | cat'
check_error 'a file that is no part of the scene' 1 '^ptrace: -state: shut: "none.rad" is not a file of the scene$' '
    ptrace $view -frames 2 -state shut=-none.rad sky.rad room.rad | cat'
# A room with two openings that do not see each other, and black shades: what goes out is lost either way, so that
# light is the sum of that of each opening.
box() { printf 'wall polygon %s 0 0 12 %s\n' "$1" "$2"; }
{
    printf 'void plastic wall 0 0 5 .6 .6 .6 0 0\nvoid plastic black 0 0 5 0 0 0 0 0\n'
    box floor '0 0 0 4 0 0 4 4 0 0 4 0'; box ceiling '0 0 3 0 4 3 4 4 3 4 0 3'
    box north '0 4 0 4 4 0 4 4 3 0 4 3'; box east '4 0 0 4 4 0 4 4 3 4 0 3'
    box low '0 0 0 4 0 0 4 0 1 0 0 1'; box high '0 0 2.5 4 0 2.5 4 0 3 0 0 3'
    box left '0 0 1 1 0 1 1 0 2.5 0 0 2.5'; box right '2 0 1 4 0 1 4 0 2.5 2 0 2.5'
    box west_low '0 0 0 0 0 1 0 4 1 0 4 0'; box west_high '0 0 2.5 0 0 3 0 4 3 0 4 2.5'
    box west_left '0 0 1 0 0 2.5 0 2 2.5 0 2 1'; box west_right '0 3 1 0 3 2.5 0 4 2.5 0 4 1'
} > two.rad
printf 'black polygon s 0 0 12 1 -.01 1 2 -.01 1 2 -.01 2.5 1 -.01 2.5\n' > s.rad
printf 'black polygon w 0 0 12 -.01 2 1 -.01 3 1 -.01 3 2.5 -.01 2 2.5\n' > w.rad
printf '1.5 1 .8 0 0 1\n1 2.5 .8 0 0 1\n2 2 .8 0 0 1\n3 3 .8 0 0 1\n' > four.pts
check 'light of two groups that do not see each other is the sum of both, in 24 hours' '
    head -n 6 y.wea > day.wea
    for h in $(seq 7 17); do for m in 3 6 9; do echo "$m 21 $h.5 500 120"; done; done | sed -n 1,24p >> day.wea
    ptrace -w- -points four.pts -wea day.wea -frames 33 -state s/open -state s/shut=s.rad -state w/open \
        -state w/shut=w.rad two.rad 2> said | ptaccum -every x2/8 | vcmetrics -W- -each > rows
    awk -F "\t" "NR > 1 { key = \$1 \" \" \$4; sign = \$2 ~ /open.*open|shut.*shut/ ? 1 : -1; split(\$8, e, /[=\\/]/)
        off[key] += sign * \$5; all[key] += e[2] ^ 2; if (\$2 ~ /open.*open/) lux += \$5 }
        END { for (k in off) { n++; z = all[k] ? off[k] ^ 2 / all[k] : 0; sum += z; far += z > 16; total += off[k] }
            printf \"%d sensors by hours, z2 %.2f, %d far, %.3f %%\n\", n, sum / n, far, 100 * total / lux
            exit !(n == 96 && sum / n < 2 && far <= 2 && lux > 0) }" rows > sums || { cat sums >&2; false; }'
check 'vcyear adds up the light of groups whose other ones are black' '
    sed "s,shut,black,g" rows > whole.tsv; grep -v "s/open+w/open" whole.tsv > parts.tsv; echo "# none" > none.txt
    sum() { vcyear -w- -shades "schedule none.txt" -honeybee $1 $1.tsv > said; tr "\t " "\n" < $1/four.ill; }
    sum parts > sums; sum whole | paste - sums |
        awk "{ n++; a += \$1; b += \$2; d = \$1 - \$2; far += d * d > (.02 * \$1) ^ 2 }
        END { printf \"%g lx, %g lx, %d of %d far\n\", a, b, far, n
            exit !(n == 96 && (b / a - 1) ^ 2 < .002 ^ 2 && far <= 2) }" > said || { cat said >&2; false; }'
