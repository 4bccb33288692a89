# SPDX-License-Identifier: BSD-3-Clause
# A folder as honeybee-radiance writes it is a scene: all that its octree would hold, and nothing else.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcregion
cp -r "$TOP/examples/exports/honeybee" model
printf 'void glow sky 0 0 4 100 100 100 0\nsky source dome 0 0 4 0 0 1 180\n' > sky.rad
static='model/scene/envelope.mat model/scene/shades.mat model/scene/envelope.rad model/scene/shades.rad
    model/aperture/aperture.mat model/aperture/aperture.rad'
render() { ptrace -vf model/view/desk.vf -x 32 -y 32 -frames 16 "$@" sky.rad | ptaccum -last; }
ev() { vcmetrics -metrics Ev "$1" | tail -n 1 | cut -f 2; }

check 'a building opposite counts' '
    render model > with.hdr
    mv model/scene/shades.* .; render model > without.hdr; mv shades.* model/scene
    awk "BEGIN { exit !($(ev with.hdr) < .8 * $(ev without.hdr)) }"'
check 'the folder is what the list of its files is' '
    render $static > list.hdr; render model > a.hdr; render ./model/ > b.hdr
    for one in list a b; do vcmetrics -metrics Ev,Lavg $one.hdr | tail -n 1 | cut -f 2- > $one; done
    cmp list a; cmp list b'

mkdir -p model/aperture_group model/scene_dynamic/indoor model/ies model/bsdf
part() { echo "void $1 m_$2 $3 m_$2 polygon $2 0 0 9 $4"; }
lamp=$(part light lamp '0 0 3 50 50 50' '1 5 2.9  2 5 2.9  2 4 2.9')
glass='0 0 3 .5 .5 .5'
part glass east "$glass" '4 1 1  4 3 1  4 3 2' > model/aperture_group/east..default..0.rad
part glass wrong "0 0 3 .1 .1 .1" '4 1 1  4 3 1  4 3 2' | tee model/aperture_group/east..default..1.rad \
    model/aperture_group/east..direct..0.rad > model/aperture_group/east..black.rad
part plastic leaves '0 0 5 .2 .2 .2 0 0' '0 -3 0  2 -3 0  2 -3 3' > model/scene_dynamic/leaves..default..0.rad
part plastic blind '0 0 5 .6 .6 .6 0 0' '0 1 2  3 1 2  3 1 1' > model/scene_dynamic/indoor/blind..default..0.rad
echo "$lamp" > model/ies/lamp.rad
part light twice '0 0 3 900 900 900' '1 5 2.8  2 5 2.8  2 4 2.8' > model/ies/__lamp__.rad
surfaces() { ptrace -M x "$@" sky.rad | tr ' ' '\n' | grep -o '[^/]*[.]rad' | sort -u | tr '\n' ' '; }
check 'first states of aperture groups and dynamic shades, and luminaires' '
    [ "$(surfaces model)" = "aperture.rad blind..default..0.rad east..default..0.rad envelope.rad lamp.rad \
leaves..default..0.rad shades.rad sky.rad " ]'

cp "$TOP/tests/fuzz/seeds/scene_bsdf/"*.xml model/bsdf/ || :
xml=$(cd model/bsdf && ls *.xml | head -n 1)
check 'BSDF files are found, from wherever the model is rendered' '
    part BSDF slats "6 0 model/bsdf/$xml 0 0 1 . 0 0" "4 1 1  4 3 1  4 3 2" > model/scene_dynamic/slats..default..0.rad
    render model > a.hdr; mkdir -p elsewhere; cp sky.rad elsewhere; cd elsewhere
    ptrace -vf ../model/view/desk.vf -x 8 -y 8 -frames 1 ../model sky.rad > b.hdr
    rm ../model/scene_dynamic/slats*'
check 'regions are drawn in such a folder' '
    echo "pane modifier generic_exterior_window*" > r.txt
    vcregion -vf model/view/desk.vf -x 64 -y 64 -o r.exr r.txt model; test -s r.exr'
check_error 'another folder is told as such' 1 \
    '^ptrace: empty: is a folder, but no model of Honeybee: it has no scene/[*].rad' '
    mkdir empty; ptrace -frames 1 empty > x'
