# SPDX-License-Identifier: BSD-3-Clause
# What the natural commands leave in a file, RADIANCE's programs and evalglare read (those that are on PATH).
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics getinfo
cp "$TOP"/examples/scenes/office/* .
ptrace -w- -vf view.vf -x 64 -y 64 -frames 8 materials.rad layout.rad sky_1400.rad > frames
ptaccum -last frames > last.hdr
ptaccum -last frames -o sum.exr
ptaccum sum.exr > merged.hdr
ptaccum sum.exr -o named.hdr
ptrace -w- -vf view.vf -x 64 -y 64 -frames 8 materials.rad layout.rad sky_1400.rad | ptaccum -last -o piped.pic
has() { command -v "$1" > /dev/null; }
for picture in last.hdr merged.hdr named.hdr piped.pic; do
    check "getinfo $picture" "
        getinfo $picture | grep -q FORMAT=32-bit_rle_rgbe && getinfo -d $picture | grep -q -- '-Y 64 +X 64'"
    for program in 'pfilt -1 -x /2 -y /2' 'pcond -h' 'pvalue -h -H' pextrem 'pflip -h' ra_ppm 'ra_xyze -r' ra_xyze \
            'pcomb -s 2'; do
        has "${program%% *}" || continue
        check "$program $picture" "$program $picture > out 2> said && [ -s out ] && [ ! -s said ]"
    done
    has evalglare || continue
    check "evalglare $picture: DGP as vcmetrics has it of the sum" "
        evalglare $picture 2> said | sed -n 's/^dgp,.*: *\([0-9.]*\) .*/\1/p' > theirs;
        vcmetrics -metrics DGP sum.exr | tail -n 1 | cut -f 2 > ours
        paste theirs ours | awk '{ found = NF == 2; exit !(found && (\$1 - \$2)^2 < 4e-6) }'"
done
