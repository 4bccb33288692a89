# SPDX-License-Identifier: BSD-3-Clause
# Pictures of an action (ACTION=, ptrace -action) beside the ordinary ones: their files.
. "${TOP:?}/tests/lib.sh"
needs ptaccum vcmetrics mkstream
# The stream of an ordinary picture again, as that of an action: its name, bands and unit.
of_action() { LC_ALL=C sed "s|^FRAME=|ACTION=$1\n&|"; }
mkstream frames 0 8 16 16 > ordinary.str
of_action 'mel 9 lx' < ordinary.str > mel.str; of_action 'V 12 lx' < ordinary.str > v.str
cat ordinary.str mel.str v.str > all.str

check 'pictures of actions go to files beside the ordinary one' '
    ptaccum -last -o office.exr < all.str; strings office_mel.exr | grep -q "^ACTION=mel 9 lx"
    ! strings office.exr | grep -q ACTION=; [ "$(ls office*.exr | tr "\n" " ")" = "office.exr office_V.exr office_mel.exr " ]'
check 'and those of several views likewise' '
    for v in desk door; do LC_ALL=C sed "s|^FRAME=|VIEWNAME=$v\n&|" all.str; done | ptaccum -last -o "%s.exr"
    ls desk.exr desk_mel.exr desk_V.exr door.exr door_mel.exr door_V.exr'
check 'a stream of sums says which is which' '
    ptaccum -every 8 < all.str | strings | grep "^ACTION=\|^FRAMES=8" | uniq | tr "\n" " " > is
    grep -qx "FRAMES=8 ACTION=mel 9 lx FRAMES=8 ACTION=V 12 lx FRAMES=8 " is'
check_error 'they are not merged' 1 '^ptaccum: office_mel.exr: has action mel of 9 bands in lx, office.exr has no action' '
    ptaccum office.exr office_mel.exr -o both.exr'
check_error 'nor is a sum of one continued by frames of the other' 1 'has no action \(ACTION=\), office_mel.exr has' '
    mkstream frames 9 12 16 16 > more.str; ptaccum office_mel.exr more.str -o both.exr'
check_error 'a line that is no such' 1 'header line "ACTION=mel lx" is not ACTION=name bands' '
    of_action "mel lx" < ordinary.str | ptaccum -last -o x.exr'
