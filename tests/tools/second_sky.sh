# SPDX-License-Identifier: BSD-3-Clause
# Two skies in one picture: whichever way each is given, an error or a warning names it, and -second-sky allows it.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics
cat > room.rad <<'END'
void plastic white 0 0 5 .5 .5 .5 0 0
white polygon floor 0 0 12 0 0 0 4 0 0 4 4 0 0 4 0
void light lamp 0 0 3 100 100 100
lamp sphere bulb 0 0 4 2 2 3 .1
void light pane 0 0 3 9 9 9
pane polygon window 0 0 12 0 0 1 0 4 1 0 4 2 0 0 2
void illum lit 0 0 3 5 5 5
lit polygon shade 0 0 12 4 0 1 4 0 2 4 4 2 4 4 1
void glow sign 0 0 4 9 9 9 0
sign source star 0 0 4 0 1 .2 .5
void light off 0 0 3 0 0 0
off source dark 0 0 4 0 0 1 180
END
cat > sun.rad <<'END'
void light solar 0 0 3 5e6 5e6 5e6
solar source sun 0 0 4 -.3 -.5 .8 .533
END
cat > blue.rad <<'END'
void glow blue 0 0 4 20 25 30 0
blue source sky 0 0 4 0 0 1 180
END
cat > ground.rad <<'END'
void glow brown 0 0 4 5 4 3 0
brown source ground 0 0 4 0 0 -1 180
END
cat > day.rad <<'END'
!gendaylit 6 21 12 -a 48 -o -11 -m -15 -W 700 100
skyfunc glow sky_glow 0 0 4 1 1 1 0
sky_glow source sky 0 0 4 0 0 1 180
END
cp day.rad other.rad
cat day.rad room.rad > all.rad
echo '!xform -rz 30 day.rad' > turned.rad
{ head -n 1 blue.rad; echo 'void alias again blue'; echo 'again source sky 0 0 4 0 0 1 180'; } > alias.rad
mkdir -p hb/scene hb/aperture && cp room.rad hb/scene/envelope.rad && cp day.rad hb/scene/sky.rad
printf 'scene= room.rad day.rad\nview= v -vta -vp 2 2 1 -vd 0 1 0 -vh 180 -vv 180\n' > in.rif
cat > y.wea <<'END'
place Here
latitude 48
longitude -11
time_zone -15
site_elevation 500
weather_data_file_units 1
6 21 0.5 0 0
6 21 12.5 700 100
END
trace() {
    ptrace -vta -vp 2 2 1 -vd 0 1 0 -vh 180 -vv 180 -x 8 -y 8 -frames 2 "$@" | cat > out.str
    return "${PIPESTATUS[0]}"
}
last_line() { "$@" 2> said || { local s=$?; tail -n 1 said >&2; return $s; }; }
sky='^ptrace: [^ ]+:[0-9]+: source "[a-z_]+" is a'

# Ways in which a scene gets its sky; a weather file and -sky give another.
while read -r way; do
    check_error "-wea beside $way" 1 "$sky (sun|sky) beside that of the weather file; -second-sky allows it\$" \
        "last_line trace -wea y.wea $way"
    check_error "also where all hours are dark" 1 'beside that of the weather file' \
        "last_line trace -wea y.wea -hours 0621_0030 $way"
    check_error "-sky beside $way" 1 \
        "$sky second (sun|sky), beside source \"[a-z_]+\" of [^ ]+:[0-9]+; -second-sky allows it\$" \
        "last_line trace -sky other.rad $way"
    check '-second-sky allows both' "
        trace -second-sky -wea y.wea $way 2> said && trace -second-sky -sky other.rad $way 2> said"
done <<'END'
room.rad day.rad
all.rad
room.rad sun.rad
room.rad blue.rad
room.rad turned.rad
room.rad alias.rad
hb
-rif in.rif v
END
check 'two among the scene files: a warning' 'trace day.rad blue.rad room.rad 2> said
    second="blue.rad:2: source \"sky\" is a second sky, beside source \"sky\" of day.rad:[0-9]+: both give light"
    grep -qE "^ptrace: warning: $second$" said'
check 'also by a rad input file' 'printf "scene= room.rad day.rad blue.rad\nview= v -vd 0 1 0\n" > two.rif
    trace -rif two.rif 2> said; grep -q "is a second sky" said'
check 'a sky that an edit brings is refused, and frames go on without it' '
    mkfifo ctl; echo "void plastic grey 0 0 5 .5 .5 .5 0 0" > more.rad
    { sleep 1; cat blue.rad > more.rad; echo scene > ctl; } &
    timeout 40 ptrace -vta -vp 2 2 1 -vd 0 1 0 -x 8 -y 8 -frames 999999 -watch -control ctl -wea y.wea \
        -hours 0621_1230 room.rad more.rad 2> said | cat > out.str & pid=$!
    for k in $(seq 180); do grep -q "a sky beside" said && break; sleep .1; done; was=$(wc -c < out.str)
    for k in $(seq 100); do [ $was -ge $(wc -c < out.str) ] || break; sleep .1; done
    kill $pid; wait $pid || :; [ $was -lt $(wc -c < out.str) ]
    grep -qE "^ptrace: more.rad:2: source \"sky\" is a sky beside that of the weather file" said'

check 'lamps, lit windows, illums and far signs are no skies' '
    trace -wea y.wea room.rad 2> said; [ "$(grep -c . said)" = 1 ]
    trace -sky day.rad room.rad 2> said && [ ! -s said ]'
check 'a ground beside -sky is none, nor is a sun beside a sky that has none' '
    trace -sky day.rad room.rad ground.rad 2> said; [ ! -s said ]
    trace -sky blue.rad room.rad sun.rad 2> said && [ ! -s said ]'
check_error 'but a ground beside that of a weather file' 1 'ground.rad:2: source "ground" is a sky beside' \
    'last_line trace -wea y.wea room.rad ground.rad'
