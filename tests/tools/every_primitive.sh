# SPDX-License-Identifier: BSD-3-Clause
# A scene with every primitive type at once renders, without a warning, to the same pixels on every device.
. "${TOP:?}/tests/lib.sh"
needs ptrace
scene=$TOP/tests/golden/every/every.rad
export scene
export RAYPATH=.:$TOP/tests/golden/every:$TOP/tests/golden/vectors
export view='-vtv -vp 0 -14 10 -vd 0 1 -.7 -x 48 -y 48 -ab 2 -frames 2'

check 'every type of the language is in the scene' '
    for t in source sphere bubble polygon cone cup cylinder tube ring mesh instance light illum glow spotlight mirror \
        prism1 prism2 mist plastic metal trans plastic2 metal2 trans2 ashik2 WGMDfunc dielectric interface glass \
        plasfunc metfunc transfunc plasdata metdata transdata BRTDfunc BSDF aBSDF antimatter \
        texfunc texdata colorfunc brightfunc colordata brightdata colorpict \
        colortext brighttext spectrum specfile specdata specfunc specpict mixfunc mixdata mixpict mixtext alias
    do grep -qE "^[^ ]+ $t " "$scene" || { echo "no $t"; exit 1; }; done'
check 'it renders without a message' '
    ptrace -device cpu $view "$scene" 2> talk | cat > cpu && test ! -s talk'
if ptrace -devices | grep -q '^opencl'; then
    check 'OpenCL gives the same pixels' '
        ptrace -device opencl $view "$scene" > opencl && cmp <(tail -c 27648 cpu) <(tail -c 27648 opencl)'
fi
