# SPDX-License-Identifier: BSD-3-Clause
# What ptrace says when it cannot: one line that names tool, place and fact; status 1 for input, 2 for the system.
. "${TOP:?}/tests/lib.sh"
needs ptrace
view='-vtv -vp 0 0 2 -vd 0 .1 -1 -vu 0 1 0 -vh 40 -vv 40 -x 8 -y 8'
printf 'void plastic mat 0 0 5 .5 .5 .5 0 0\nmat polygon floor 0 0 12 -5 -5 0 5 -5 0 5 5 0 -5 5 0\n' > dark.rad
{ cat dark.rad; printf 'void glow sky 0 0 4 1 1 1 0\nsky source s 0 0 4 0 0 1 180\n'; } > good.rad
printf 'void plastic mat 0 0 5 .5 .5 .5 0 0\n\nglas polygon floor 0 0 12 -5 -5 0 5 -5 0 5 5 0 -5 5 0\n' > modifier.rad
printf 'void plastic mat 0 0 5 .5 .5 .5 0\n' > short.rad
printf '!touch ran\n' > command.rad
printf 'void light l 0 0 3 1 10 3e38\nl polygon p 0 0 9 360 0 1 0 1 180 1 0 1\n' | cat - good.rad > bright.rad
mkdir folder

check 'a scene without light is rendered with a warning' '
    ptrace $view -frames 1 dark.rad 2> said | cat > t; grep -q "is the sky missing" said; [ $(wc -l < said) = 1 ]
    rm dark.rad said t'
check 'a good scene renders' "ptrace $view -frames 2 good.rad"
check_error 'an undefined modifier names its line' 1 '^ptrace: modifier.rad:3: .*"?glas"?.* not defined' "
    ptrace $view -frames 1 modifier.rad | cat"
check_error 'too few arguments name their primitive' 1 '^ptrace: short.rad:2: .*"mat"' "
    ptrace $view -frames 1 short.rad | cat"
check_error 'a missing scene' 2 '^ptrace: absent.rad: .*No such file' "ptrace $view -frames 1 absent.rad | cat"
check_error 'a function file that is in no folder searched' 1 '^ptrace: -f: cannot find function file "absent.cal"' "
    ptrace $view -frames 1 -f absent.cal good.rad | cat"
if [ "$(awk '/^MemTotal/ { print $2 }' /proc/meminfo)" -lt 60000000 ]; then
    check_error 'a picture that is larger than memory says so before the work' 2 \
        '^ptrace: -x, -y: 32768 x 32768 pixels need at least 64[.]4 GB; this machine has [0-9]+[.][0-9] GB$' "
        ptrace $view -x 32768 -y 32768 -frames 1 good.rad | cat"
fi
for option in -vf -views -sky -focus -f -e -o -M -MF -rif; do
    check_error "$option without a name" 1 "^ptrace: $option: the name is empty" "
        ptrace $view $option '' -frames 1 good.rad > /dev/null"
done
check_error 'a scene without a name' 1 '^ptrace: "": is not the name of a file' "ptrace $view -frames 1 '' > /dev/null"
printf 'rvu -vta -vp 2 2,6 1 -vh 180 -vv 180\n' > comma.vf
printf 'VIEW= a -vta -vh 180 -vv 180\nVIEW= b -vd 0 1\n' > short.vf
printf 'rpict -vp 1 1 scene.oct\nVIEW= -vtv -vp 1 1 1\n' > last.vf
check_error 'a view file with a word that is no number' 1 '^ptrace: comma.vf: -vp: "2,6" is not a number' "
    ptrace $view -vf comma.vf -frames 1 good.rad | cat"
check_error 'a list of views with too few numbers' 1 '^ptrace: short.vf:2: -vd: an argument is missing' "
    ptrace $view -views short.vf -frames 1 good.rad | cat"
check 'a line before the last view may look like one' "ptrace $view -vf last.vf -frames 1 good.rad | cat > /dev/null"
ptrace $view -frames 1 good.rad > picture.hdr 2> /dev/null
check_error 'a picture is not a scene' 1 '^ptrace: picture.hdr: is not a scene: its header says FORMAT=float' "
    ptrace $view -frames 1 picture.hdr | cat"
printf '\357\273\277rvu -vth -vp 0 0 1 -vd 0 0 -1 -vu 0 1 0 -vh 180 -vv 180\r\n' > mark.vf
check 'a view file of an editor that marks UTF-8' "
    for o in -vf -views; do ptrace $view \$o mark.vf -frames 1 good.rad 2> said | strings | grep -q '^VIEW= -vth'; done"
rm comma.vf short.vf last.vf mark.vf picture.hdr said
printf '!genbox mat box 4 5 3 -i\nvoid light l 0 0 3 9 9 9\nl sphere s 0 0 4 2 2 2 .1\n' > room.rad
# in_units S: the same room, S times as large
in_units() {
    printf 'void plastic mat 0 0 5 .5 .5 .5 0 0\n!xform -s %s room.rad\n' "$1" |
        ptrace -vta -vp $(echo 2 1 1 | awk -v s="$1" '{ print s * $1, s * $2, s * $3 }') -vh 180 -vv 180 \
            -x 8 -y 8 -frames 1 - 2> said > frame
}
check 'a room in kilometres, metres or millimetres is rendered without a word' '
    for s in .001 1 1000; do in_units $s; ! grep -v "writing frames" said || exit 1; done'
rm -f room.rad said frame
printf 'LOCATION,Here\nDATA PERIODS,1\n' > weather.epw
printf 'place Here\nlatitude 1\n' > weather.wea
printf '# rad\nscene= good.rad\n' > input.rif
for file in weather.epw weather.wea; do
    check_error "weather is no scene: $file" 1 "^ptrace: $file: is a weather file, no scene: ptrace -wea takes it$" "
        ptrace $view -frames 1 $file | cat"
done
check_error 'nor is an input file of rad' 1 \
    '^ptrace: input.rif:2: "scene=" is of an input file of rad.1.: ptrace -rif takes it$' "
    ptrace $view -frames 1 input.rif | cat"
check_error 'a folder is no weather' 1 '^ptrace: [.]: is a folder; a file of weather is needed, EPW or WEA$' "
    ptrace $view -wea . -frames 1 good.rad | cat"
rm weather.epw weather.wea input.rif
check_error 'a folder that is no model of Honeybee' 1 '^ptrace: folder: ' "ptrace $view -frames 1 folder | cat"
check_error 'commands do not run unasked' 1 '^ptrace: command.rad:1: .*-exec' "ptrace $view -frames 1 command.rad | cat"
check 'and did not' 'test ! -e ran'
check_error 'a full disk' 2 '^ptrace: .*No space left' "ptrace $view -frames 2 good.rad > /dev/full"
check_error 'a folder that is not there' 2 '^ptrace: ' "ptrace $view -frames 1 -o nowhere/f.hdr good.rad"
check_error 'no OpenCL platform' 2 '^ptrace: .*[Oo]penCL' "
    OCL_ICD_VENDORS=/nonexistent ptrace $view -device opencl -frames 1 good.rad | cat"
check_error 'no such device' 1 '^ptrace: -device: ' "ptrace $view -device abacus -frames 1 good.rad | cat"
check_error 'a wrong number' 1 '^ptrace: -ab' "ptrace $view -ab many -frames 1 good.rad | cat"
check_error 'a view without direction' 1 '^ptrace: ' "ptrace $view -vd 0 0 0 -frames 1 good.rad | cat"
check 'light too bright for sums of floats is left out, and the picture is of numbers' \
  "(ptrace -vta -vp .1 -2 .3 -vd 0 1 0 -vh 180 -vv 180 -x 8 -y 8 -ab 2 -ds .2 -frames 2 bright.rad |
    ptaccum -o sum.exr -) 2> said && ! grep '^ptaccum: warning' said"
check 'which is said' "grep -q '^ptrace: warning: samples that were not numbers, or above 1e32, were set to 0' said"
rm -f sum.exr bright.rad said
check 'nothing half-written is left' '
    test "$(ls | sort | tr "\n" " ")" = "command.rad folder good.rad modifier.rad short.rad "'
check 'a reader that leaves ends an endless stream quietly' "
    ptrace $view good.rad | head -c 2000 > first && test ! -s .stderr"

# An eye where none can be meant.
cat > units.rad << 'END'
void plastic wall 0 0 5 .5 .5 .5 0 0
void glow lamp 0 0 4 1 1 1 0
!genbox wall room 4 6 3 -i
lamp ring lamp 0 0 8 2 3 2.99 0 0 -1 0 .5
END
eye() { ptrace -vta -vh 180 -vv 180 -x 8 -y 8 -frames 1 -moments- -vp "$@" | cat > x.str; }
scaled() { printf '!xform -s %s units.rad\n' "$1" > scaled.rad; }
check 'an eye in a room is no news' 'eye 2 2.6 1.2 -vd 0 -1 0 units.rad 2> said; cat said; [ ! -s said ]'
check_error 'a model in millimetres under an eye in metres, by the size of its room' 0 \
    '^ptrace: warning: -vp: .* corner of a room of 4000 x 6000 x 3000: is the model in millimetres' '
    scaled 1000; eye 2 2.6 1.2 -vd 0 -1 0 scaled.rad'
check_error 'an eye that is metres away from a model of millimetres' 0 \
    '^ptrace: warning: -vp: the eye is 3.* are they in the same units' '
    scaled .001; eye 2 2.6 1.2 -vd 0 -1 0 scaled.rad'
check_error 'an eye inside a solid' 0 '^ptrace: warning: -vp: surfaces .* 0.004 x 0.006 x 0.003: is it inside a solid' '
    scaled .001; echo "!xform -t -1 -1 -1 units.rad" >> scaled.rad; eye .002 .002 .001 -vd 0 -1 0 scaled.rad'
check_error 'the third eye of a file' 0 '^ptrace: warning: view roof: the eye is .* are they in the same units' '
    for v in "one -vp 2 2 1" "two -vp 2 2 1.5" "roof -vp 2 2 9999"; do echo "VIEW= $v -vd 0 1 0"; done > v.vf
    ptrace -views v.vf -x 8 -y 8 -frames 1 -moments- units.rad | cat > x.str'
check_error 'an eye under the ground' 0 \
    '^ptrace: warning: -vp: all surfaces are above the eye: is it under the ground' '
    { cat units.rad; echo wall ring ground 0 0 8 2 3 -.1 0 0 1 0 100; } > ground.rad; eye 2 3 -1 -vd 0 1 0 ground.rad'
