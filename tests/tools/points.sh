# SPDX-License-Identifier: BSD-3-Clause
# ptrace -points: points from files and from the standard input, their header lines, sums, shares and mistakes.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum
printf 'void glow g 0 0 4 1 1 1 0\ng source sky 0 0 4 0 0 1 180\n' > sky.rad
printf 'void light l 0 0 3 9 9 9\nl sphere s 0 0 4 0 0 3 .1\nvoid plastic p 0 0 5 .5 .5 .5 0 0\np ring r 0 0 8 0 0 0 0 0 1 0 9\n' \
    > room.rad
printf '# a desk\n1 1 .7 0 0 1\n\n2 1 .7 0 0 2 # twice as long\n' > desk.pts
printf '0 0 0.1 1 0 0\r\n' > 'wall.a.pts'
lines() { ptaccum -every 1000 -o - | command strings -n 5 | grep -x "$1"; }

check 'each file is a grid; the header says which pixels are its own' '
    ptrace -points desk.pts -points wall.a.pts -frames 2 sky.rad room.rad | ptaccum -last -ff > both
    grep -aqx "GRID=desk 0 2 irradiance [0-9a-f]\{16\}" both; grep -aqx "GRID=wall.a 2 1 irradiance [0-9a-f]\{16\}" both
    grep -aqx -e "-Y 2 +X 2" both; ! grep -aq "^VIEW=" both; grep -aqx "FRAME0=0" both'
check 'the standard input is one, too' '
    ptrace -points - -frames 2 sky.rad room.rad < desk.pts | ptaccum -last -ff | grep -aq "^GRID=points 0 2 irradiance"'
check '-I- is the radiance along the ray' '
    ptrace -I- -points desk.pts -frames 2 sky.rad room.rad | ptaccum -last -ff | grep -aq "^GRID=desk 0 2 radiance"'
check 'shares of the frames merge to the bits of one run' '
    share() { ptrace -points desk.pts -frames "$1" sky.rad room.rad | ptaccum -last -o "$2"; }
    share 10 all.exr; share 0:4 a.exr; share 5:9 b.exr; ptaccum a.exr b.exr -o merged.exr
    for f in all merged; do ptaccum $f.exr -ff -o - | tail -c 24 > $f; done; cmp all merged'
check_error 'other points, or another order of them, are not summed' 1 'other.exr: has other points than a.exr' '
    tac desk.pts > other.pts; ptrace -frames 5:9 -points other.pts sky.rad room.rad | ptaccum -last -o other.exr
    ptaccum a.exr other.exr -o x.exr'
check 'each sky has a picture' '
    ptrace -points desk.pts -sky sky.rad -sky room.rad -frames 2 room.rad | ptaccum -last -ff > skies
    test "$(grep -acx "SKYNAME=sky" skies)" = 1 && test "$(grep -acx "SKYNAME=room" skies)" = 1'
check 'the bits hang neither on threads nor on the device' '
    seq 300 | awk "{print \$1 % 20 / 9, \$1 / 99, .5, 0, 0, 1}" > many.pts
    ptrace -n 1 -points many.pts -frames 3 sky.rad room.rad > one
    for how in "-n 3" "-device cpu:baseline"; do
        ptrace $how -points many.pts -frames 3 sky.rad room.rad | tail -c 3888 | cmp - <(tail -c 3888 one)
    done'

bad() { printf "$1" > bad.pts; ptrace -points bad.pts -frames 2 sky.rad; }
check_error 'five numbers are not a point' 1 '^ptrace: bad.pts:2: a point is x y z dx dy dz, six numbers, not 5' \
    'bad "0 0 0 0 0 1\n1 2 3 4 5\n"'
check_error 'nor are seven' 1 '^ptrace: bad.pts:1: a point is .* not 7' 'bad "0 0 0 0 0 1 7"'
check_error 'words are no numbers' 1 '^ptrace: bad.pts:1: "nan" is not a number' 'bad "0 0 nan 0 0 1"'
check_error 'a direction has a length' 1 '^ptrace: bad.pts:3: the direction has no length' 'bad "\n\n0 0 0 0 0 0"'
check_error 'an empty file has no point' 1 '^ptrace: bad.pts: holds no point' 'bad "# nothing\n"'
check_error 'a missing file is a system error' 2 '^ptrace: none.pts: cannot be ' 'ptrace -points none.pts sky.rad'
check_error 'grids have different names' 1 'two grids are called "desk"' 'ptrace -points desk.pts -points ./desk.pts sky.rad'
check_error '-views has no place beside them' 1 '^ptrace: -points: ' 'ptrace -points desk.pts -views x sky.rad'
check_error '-I needs points' 1 '^ptrace: -I: needs the points of -points' 'ptrace -I -frames 1 sky.rad'
check_error 'the standard input is read once' 1 'the standard input has the points' 'ptrace -points - -frames 1 - < desk.pts'
check 'points that no light reaches are named: below the floor, for one' '
    printf "0 0 1 0 0 1\n0 0 -1 0 0 -1\n" > dark.pts
    ptrace -points dark.pts -frames 2 sky.rad room.rad 2>&1 > /dev/null |
        grep -x "ptrace: warning: dark.pts:2: no light arrives at this point: is it inside a solid, or below the ground?"'
