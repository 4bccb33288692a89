# SPDX-License-Identifier: BSD-3-Clause
# The manual's EXAMPLES and examples/*.sh run as they stand, only smaller: 512 x 512 becomes 48 x 48.
# Blocks (.EX .EE) of a page run one after another in one folder, which holds the office scene and its regions.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcregion

size=48
smaller $size

# blocks PAGE: writes each example of the page to PAGE.1.sh, PAGE.2.sh ...
blocks() {
    awk -v name="$(basename "$1")" '
        /^[.]S[Hh]/ { on = /EXAMPLES/ }
        on && /^[.](EX|Bd -literal)/ { n++; inside = 1; next }
        on && /^[.](EE|Ed)/ { inside = 0; next }
        inside {
            gsub(/\\-/, "-"); gsub(/\\e/, "\\"); gsub(/\\&/, "")
            gsub(/\\\(aq/, "\047"); gsub(/\\\(ti/, "~"); gsub(/\\\(ha/, "^")
            print > (name "." n ".sh")
        }' "$1"
}

mkdir pages && cd pages || exit 2
cp "$TOP"/examples/scenes/office/* "$TOP"/examples/office.regions .
for page in luxpipe.7 ptrace.1 ptaccum.1 vcregion.1 vcmetrics.1; do blocks "$TOP/man/$page"; done
for block in luxpipe.7.* ptrace.1.* ptaccum.1.* vcregion.1.* vcmetrics.1.*; do
    [ -f "$block" ] || continue
    sed -i -E "s/(-[xy]) 512/\1 $size/g" "$block"
    check "${block%.sh}: $(head -n 1 "$block" | cut -c 1-60)" "timeout 120 bash -eo pipefail $block"
done
check 'every tool has an example' 'for t in ptrace ptaccum vcregion vcmetrics; do test -f $t.1.1.sh; done'

cd "$TMP" && cp -r "$TOP/examples" .
for tool in ptrace vcmetrics vcyear; do
    $tool -help |
        awk 'NR == 2 && /^In the folder examples.scenes.office[:,]/ { on = 1; next }
             /^[^ ]/ { on = 0 } on' > $tool.begins
    check "$tool -help begins with three commands that work" "
        [ \"\$(grep -c '^  [a-z]' $tool.begins)\" = 3 ]; cd examples/scenes/office
        timeout 200 bash -eo pipefail $TMP/$tool.begins"
done
for script in examples/[0-9]*.sh; do
    check "$script is short" "test \$(wc -l < $script) -le 20"
    check "$script runs" "SIZE=$size FRAMES=8 timeout 300 bash $script"
done
