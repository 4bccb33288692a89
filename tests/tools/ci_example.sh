# SPDX-License-Identifier: BSD-3-Clause
# examples/ci: passes as recorded, fails on drift, records anew.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics make
mkdir examples && cp -r "$TOP/examples/ci" "$TOP/examples/scenes" examples && cp -r "$TOP/mk" .
cd examples/ci || exit 2

check 'the scene as it was recorded passes' 'make check > log; [ "$(grep -c "yes$" log)" -ge 6 ]'
check_exit 'one that has drifted fails' 2 '
    sed -i "s/^5 .68 .67 .64/5 .2 .2 .2/" ../scenes/office/materials.rad; make check > log'
check 'and tells in what' 'grep -q "desk.exr.Ev.*no$" log'
check 'until it is recorded anew' 'make record; make check'
