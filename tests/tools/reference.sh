# SPDX-License-Identifier: BSD-3-Clause
# Pictures of real scenes against rtrace -u+ (tests/golden/uncorrelated): blocks of 16 x 16 pixels in standard errors of
# both.  Noise of the check itself: a block's error is 1 to 4 %, so its rms over 256 blocks is 1 +- .045 if all is well
# (the few batches make ours uncertain, and +.05 of it); the mean's error is .1 to .25 %.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum study_reference_compare

# scene skies: 64 frames in 16 batches, each with its scatter
render() {
    local name=$1 first last parts=()
    cd "$TOP/examples/scenes/office"
    shift
    for ((b = 0; b < 16; b++)); do
        first=$((4 * b + (b > 0))) last=$((4 * b + 4))
        parts+=("$TMP/$name.$b.exr")
        ptrace -w- -ss 4 -vf view.vf -x 256 -y 256 -ab 6 -frames "$first:$last" "$@" |
                ptaccum -last -o "$TMP/$name.$b.exr"
    done
    cd "$TMP"
    ptaccum "${parts[@]}" -o "$name.exr"
    study_reference_compare - "$TOP/tests/golden/uncorrelated/$name.blocks.tsv" "$name.exr" "${parts[@]}" > "$name.tsv"
    cat "$name.tsv" >&2
}
# blocks, share within 3 errors, rms, mean %, its error
agrees='{ exit !($2 >= .98 && $3 < 1.2 && $4 < .7 && $4 > -.7) }'
export -f render
export agrees

check 'the overcast office' '
    render office_clear_overcast materials.rad layout.rad sky_overcast.rad; awk "$agrees" office_clear_overcast.tsv'
check 'the office in the morning sun' '
    render office_clear_0900 materials.rad layout.rad sky_0900.rad; awk "$agrees" office_clear_0900.tsv'
