# SPDX-License-Identifier: BSD-3-Clause
# ptaccum: Eq. 7 on streams whose sums are known by hand, ranges and their merging, broken input, broken output.
. "${TOP:?}/tests/lib.sh"
needs ptaccum vcmetrics mkstream

# Frame 0 is 10, frame k is k:  L'(n) = 10 + (1 + 2 + ... + n)/n = 10 + (n + 1)/2.
mkstream numbers 0 8 > n8.hdr
check 'every frame gives the sum up to it' '
    ptaccum < n8.hdr | mkstream show - | cut -d" " -f2- | head -4 > is
    printf "FRAMES=0 RANGE=0:0 10\nFRAMES=1 RANGE=0:1 11\nFRAMES=2 RANGE=0:2 11.5\nFRAMES=3 RANGE=0:3 12\n" | diff - is'
check '-last writes one picture, the last' '
    [ "$(ptaccum -last -ff < n8.hdr | mkstream show -)" = "8x8 FRAMES=8 RANGE=0:8 14.5" ]'
check '-every 3 writes 0, 3, 6 and the last' '
    [ "$(ptaccum -every 3 n8.hdr | mkstream show | sed "s/.*FRAMES=//; s/ .*//" | tr "\n" " ")" = "0 3 6 8 " ]'
check '-every x2 writes the doublings' '
    [ "$(mkstream numbers 0 20 | ptaccum -every x2 | mkstream show | sed "s/.*FRAMES=//; s/ .*//" |
        tr "\n" " ")" = "0 1 2 4 8 16 20 " ]'
check '-every x2/4 writes 4 in each doubling' '
    [ "$(mkstream numbers 0 40 | ptaccum -every x2/4 | mkstream show | sed "s/.*FRAMES=//; s/ .*//" | tail -6 |
        tr "\n" " ")" = "19 23 27 32 38 40 " ]'
check 'a frame 0 in mid-stream restarts, the sum before it is written' '
    { mkstream numbers 0 4; mkstream numbers 0 2; } | ptaccum -last -ff | mkstream show > is
    printf "8x8 FRAMES=4 RANGE=0:4 12.5\n8x8 FRAMES=2 RANGE=0:2 11.5\n" | diff - is'
check 'frames in files are read one after another' '
    for k in 0 1 2; do mkstream numbers $k $k > f$k.hdr; done
    [ "$(ptaccum -last -ff f0.hdr f1.hdr f2.hdr | mkstream show)" = "8x8 FRAMES=2 RANGE=0:2 11.5" ]'
check 'the header holds VIEW= once, SEED=, FRAMES=, RANGE=, both command lines and no FRAME=' '
    mkstream frames 0 3 | ptaccum -last | head -c 2000 | tr -d "\000" | sed "/^\$/,\$d" > head
    [ "$(grep -c "^VIEW=" head)$(grep -c "^SEED=1" head)$(grep -c "^FRAMES=3" head)$(grep -c "^RANGE=0:3" head)" = \
        1111 ]
    grep -q "^mkstream frames 0 3" head && grep -q "^ptaccum -last" head && grep -q "^FORMAT=32-bit_rle_rgbe" head &&
        ! grep -q "^FRAME=" head'

# Frame 0 is 10, all pixels of a frame k are k: after n frames the mean is 10 + (n + 1)/2 and its standard error
# sqrt((n + 1)/12).  One block tells its error from 31 frames on.
check '-until ends with the first sum whose blocks are as certain' '
    mkstream numbers 0 60 > many.hdr
    [ "$(ptaccum -last -ff -until 6 many.hdr | mkstream show | sed "s/.*FRAMES=//; s/ .*//")" = "$(awk "BEGIN {
        for (n = 31; 100 * sqrt((n + 1) / 12) / (10 + (n + 1) / 2) > 6; ++n); print n }")" ]'
check '-until that is never reached gives all frames' '
    ptaccum -last -ff -until 1 many.hdr | mkstream show | grep -q "FRAMES=60 "'
check_error '-until without -last' 1 '^ptaccum: -until: needs -last' 'ptaccum -until 1 many.hdr'
check_error '-until 0' 1 '^ptaccum: -until: ' 'ptaccum -last -until 0 many.hdr'
check_error '-until with a sum that goes on' 1 '^ptaccum: -until: needs the frames of a whole sum' '
    mkstream frames 0 5 | ptaccum -last -o sum.exr; mkstream frames 6 7 > more.hdr
    ptaccum -last -until 1 sum.exr more.hdr -o x.exr'

# Ranges
mkstream frames 0 63 | ptaccum -last -ff > whole.hdr
for range in 0:9 10:40 41:63; do
    mkstream frames ${range%:*} ${range#*:} | ptaccum -last -o part_${range%:*}.exr -o - > part_${range%:*}.hdr
done
check 'parts of a run merge to the whole' '
    ptaccum part_10.exr part_0.exr part_41.exr -o all.exr > merged; [ ! -s merged ]
    [ "$(mkstream differ whole.hdr all.exr)" = 0 ]
    mkstream show all.exr | grep -q "FRAMES=63 RANGE=0:63 "'
check 'merging in two steps is merging at once' '
    ptaccum part_0.exr part_10.exr -o first.exr; ptaccum first.exr part_41.exr -o two.exr
    [ "$(mkstream differ all.exr two.exr)" = 0 ]'
check 'a partial sum says so by its RANGE' 'mkstream show part_10.hdr | grep -q "FRAMES=31 RANGE=10:40 "'
check_error 'the same frames twice are refused' 1 '^ptaccum: part_0.exr: frame 0 of seed 1 is in first.exr already' '
    ptaccum first.exr part_0.exr -o x.exr'
check_error 'the same file twice is refused' 1 '^ptaccum: first.exr: frame 0 of seed 1 is in first.exr already' '
    ptaccum first.exr first.exr -o x.exr'
check_error 'frame 0 summed in without its layer cannot be weighted' 1 'part_0.hdr: has frame 0 summed in' '
    ptaccum part_0.hdr part_10.exr -o x.exr'
check 'complete sums of two seeds average by their frames' '
    mkstream frames 0 10 16 16 1 | ptaccum -last -ff -o s1.exr -o - > s1.hdr
    mkstream frames 0 30 16 16 2 | ptaccum -last -ff > s2.hdr; ptaccum -ff s1.hdr s2.hdr > s12.hdr;
    mkstream show s12.hdr | grep -q "FRAMES=40 RANGE=0:10 "
    m1=$(mkstream show s1.hdr | sed "s/.* //") m2=$(mkstream show s2.hdr | sed "s/.* //") m=$(mkstream show s12.hdr |
        sed "s/.* //")
    echo $m1 $m2 $m | awk "{ e = (10*\$1 + 30*\$2)/40; exit !((\$3 - e)^2 <= (1e-5*e)^2) }"
    [ "$(tr -d "\000" < s12.hdr | head -c 3000 | grep -ac "^SEED=")" = 2 ]'
check_error 'a partial sum of another seed is refused' 1 'seed 2: frames 5:9 come without frame 0' '
    mkstream frames 5 9 16 16 2 | ptaccum -last > p2.hdr; ptaccum s1.exr p2.hdr -o x.exr'
check_error 'a mix of seeds takes no more of one of them' 1 'mixes with other seeds' '
    mkstream frames 11 12 16 16 1 | ptaccum -last > p1.hdr; ptaccum s12.hdr p1.hdr -o x.exr'
check_error 'another view is refused' 1 'v.exr: has another view than part_0.exr' '
    mkstream frames 64 70 16 16 1 "VIEW= -vp 1 0 0" | ptaccum -last -o v.exr; ptaccum part_0.exr v.exr -o x.exr'
check 'no refused merge left a file' '[ ! -e x.exr ] && ! ls -A | grep tmp'

# Names and header lines that lie
cp part_0.exr EXPOSURE=2.exr; cp part_10.exr 'rpict -vp 9 9 9.exr'
check 'file names are no header lines' '
    ptaccum EXPOSURE=2.exr "rpict -vp 9 9 9.exr" -o named.hdr; ptaccum part_0.exr part_10.exr -o plain.hdr
    [ "$(mkstream differ named.hdr plain.hdr)" = 0 ]; not grep -a "^EXPOSURE=" <(head -c 4000 named.hdr)
    [ "$(head -c 4000 named.hdr | grep -ac "^VIEW=.*-vp 0 0 0")" = 1 ]'
check 'nor in a history of histories, where a tab before EXPOSURE= would spoil the picture' '
    ptaccum EXPOSURE=2.exr "rpict -vp 9 9 9.exr" -o named.exr; ptaccum named.exr part_41.exr -o again.hdr
    ! head -c 4000 again.hdr | tr -d "\000" | grep -a "EXPOSURE=.*" | grep -a "	"'
check_error 'exposures that no float holds' 1 'EXPOSURE=1e308.* is not within' '
    mkstream numbers 0 2 | ptaccum -last -fc | sed "1a EXPOSURE=1e308" > e.hdr; ptaccum e.hdr -o x.hdr'
check_error 'frames that one header names twice' 1 'RANGE=0:2.*before it' '
    mkstream numbers 0 2 | ptaccum -last -fc | sed "1a RANGE=0:2" > r.hdr; ptaccum r.hdr -o x.hdr'
for every in x1e300 x1e19 x1.0000000001 x2/9000000000000000000; do
    check "-every $every ends" "timeout 20 ptaccum -every $every n8.hdr | mkstream show | grep -q FRAMES=8"
done

# Broken streams
check_error 'a missing frame' 1 '^ptaccum: stdin: picture 3: frame 2 is missing \(this is frame 3\)' '
    { mkstream numbers 0 1; mkstream numbers 3 4; } | ptaccum > out'
check_error 'missing frames' 1 'frames 2 to 4 are missing' '
    { mkstream numbers 0 1; mkstream numbers 5 5; } | ptaccum > out'
check_error 'a repeated frame' 1 'frame 1 comes twice' '{ mkstream numbers 0 1; mkstream numbers 1 1; } | ptaccum > out'
check_error 'frames out of order' 1 'frame 1 after frame 3: out of order' '
    { mkstream numbers 0 3; mkstream numbers 1 1; } | ptaccum > out'
check_error 'another size' 1 'frame 2 is 8 x 16, the frames before it are 16 x 16' '
    { mkstream frames 0 1; mkstream frames 2 2 8 16; } | ptaccum > out'
check_error 'another view' 1 'frame 2 has another view' '
    { mkstream frames 0 1; mkstream frames 2 2 16 16 1 "VIEW= -vp 1 0 0"; } | ptaccum > out'
check_error 'another seed' 1 'frame 2 has another seed' '
    { mkstream frames 0 1; mkstream frames 2 2 16 16 9; } | ptaccum > out'
check_error 'a sum among frames' 1 'is a sum of frames inside a stream' '
    { mkstream frames 0 1; mkstream frames 0 3 | ptaccum -last; } | ptaccum > out'
check_error 'a stream cut inside the pixels' 1 '^ptaccum: stdin: picture 9: input ends inside the picture' '
    head -c -100 n8.hdr | ptaccum -last -o cut.exr'
check 'what came whole before is in the file' '[ "$(mkstream show cut.exr)" = "8x8 FRAMES=7 RANGE=0:7 14" ]'
check_error 'likewise before a missing frame' 1 'frame 2 is missing' '
    { mkstream numbers 0 1; mkstream numbers 3 4; } | ptaccum -last -o hole.exr'
check 'the frames before the hole are kept' 'mkstream show hole.exr | grep -q "FRAMES=1 RANGE=0:1 "'
check_error 'a stream cut in its first frame' 1 'input ends inside the picture' '
    head -c 500 n8.hdr | ptaccum -o none.exr'
check 'nothing half-written' '[ ! -e none.exr ] && [ -z "$(ls -A | grep tmp)" ]'
check_exit 'without -o nothing is written: what follows sees no short picture' 1 '
    head -c -100 n8.hdr | ptaccum -last > cut.hdr'
check 'the file is empty' '[ -e cut.hdr ] && [ ! -s cut.hdr ]'
check_error 'a stream cut inside a header' 1 'picture 2: input ends inside the header' '
    { mkstream numbers 0 0; printf "#?RADIANCE\nFRAME=1\n"; } | ptaccum > out'
check_error 'a picture of the wrong size' 1 'input ends inside the picture' '
    sed "s/-Y 8 +X 8/-Y 9 +X 9/" n8.hdr > n9.hdr; head -c 900 n9.hdr | ptaccum > out'
check_error 'an empty input' 1 '^ptaccum: stdin: holds no picture' 'ptaccum < /dev/null'
check_error 'an unreadable file' 2 '^ptaccum: nowhere.exr: cannot be read: No such file' 'ptaccum nowhere.exr'
check_error 'a file without a name' 1 '^ptaccum: "": is not the name of a file' 'ptaccum ""'
check_error 'an output without a name' 1 '^ptaccum: -o: the name is empty' 'ptaccum n8.hdr -o ""'
check_error 'a folder is not a picture' 2 'cannot be read: Is a directory' 'ptaccum .'

# Streams that say how many frames are to come
announce() { sed "s/^SEED=/LASTFRAME=$1\n&/"; }
mkstream numbers 0 8 | announce 8 > t8.hdr
check 'an announced stream that is whole' '
    [ "$(ptaccum -last -ff t8.hdr | mkstream show)" = "8x8 FRAMES=8 RANGE=0:8 14.5" ]'
check_error 'one that ends early' 1 '^ptaccum: stdin: ends after frame 4, where frames up to 8 were announced' '
    mkstream numbers 0 4 | announce 8 | ptaccum -last -o short.exr'
check_error 'whatever ranges its frames claim' 1 'ends after frame 4' '
    mkstream numbers 0 4 | announce 8 | sed "s/^SEED=/RANGE=0:8\n&/" | ptaccum -last > out'
check 'its frames are kept' 'mkstream show short.exr | grep -q "FRAMES=4 RANGE=0:4 "'
check_error 'one that begins anew early' 1 'picture 6: begins anew after frame 4' '
    { mkstream numbers 0 4 | announce 8; mkstream numbers 0 2; } | ptaccum -last > out'
check 'the sums announce it to the next program' '
    ptaccum -every 4 t8.hdr | mkstream show | wc -l | grep -qx 3; ptaccum t8.hdr | grep -ac "^LASTFRAME=8" | grep -qx 9'
check_error 'which is reported as well' 1 '^mkstream: stdin: ends after frame 4' '
    mkstream numbers 0 4 | announce 8 | ptaccum > early.lux 2> said || :; mkstream show < early.lux'
check 'but once: behind a pipe the reader fails without a word' '
    { mkstream numbers 0 4 | announce 8 | ptaccum 2> said || :; } |
        { mkstream show 2> said2 && exit 1; [ ! -s said2 ]; }
    [ "$(wc -l < said)" = 1 ]'
sum_badly() { ptaccum "$@" 2> said && return 1; true; }
ends_with_error() { vcmetrics -W- > t 2> said2 && return 1; [ ! -s said2 ] && [ "$(wc -l < t)" = "$1" ]; }
check 'who reads the sums of frames that are refused fails, too' '
    { mkstream frames 0 3 32 32; echo rubbish; } | sum_badly | ends_with_error 5;
    grep -q "picture 5: what follows is not a picture" said'
check_error 'from a file with a word' 1 '^vcmetrics: sums.lux: picture 5: input ends inside the header' '
    { mkstream frames 0 3 32 32; echo rubbish; } | ptaccum > sums.lux 2> said || :; vcmetrics -W- sums.lux > t'
check 'also after the last one that was announced' '
    { mkstream frames 0 3 32 32 | announce 3; echo rubbish; } | sum_badly | ends_with_error 5'
check 'and with a picture by itself' '
    { mkstream frames 0 3 32 32; mkstream frames 0 1 32 32; echo rubbish; } | sum_badly -last | ends_with_error 2'
check_error 'an announcement holds until the next one' 1 'ends after frame 4, where frames up to 8' '
    { mkstream numbers 0 3 | announce 8; mkstream numbers 4 4; } | ptaccum > out'
check 'a stream in a file gets a warning: other programs misread it' '
    ptaccum t8.hdr > s.hdr 2> said; [ "$(wc -l < said)" = 1 ]; grep -q "^ptaccum: warning: stdout: .*-last" said
    for quiet in -last -ff -fc; do ptaccum $quiet t8.hdr > s.hdr 2> said; [ ! -s said ]; done;
    ptaccum t8.hdr 2> said | cat > s.hdr; [ ! -s said ]'
check 'a picture by itself announces nothing' '
    ptaccum -last t8.hdr -o l.hdr -o - > l2.hdr; ! grep -a "^LASTFRAME" l.hdr l2.hdr'
check 'a pipe that the reader closes is not an early end' '
    { mkstream frames 0 5000 32 32 | announce 5000 || true; } | ptaccum 2> said | head -c 100000 > some; [ ! -s said ]'
check 'shares in one stream' '
    { mkstream numbers 0 3 | announce 3; mkstream numbers 4 8 | announce 8;
    } | ptaccum -last -ff | mkstream show | grep -q "RANGE=0:8 14.5"'

# Going on from a sum
check 'frames are added to a sum, as if they had come in one run' '
    mkstream frames 0 31 | ptaccum -last -o c.exr; mkstream frames 32 39 | ptaccum c.exr - -o c.exr
    mkstream frames 0 39 | ptaccum -last -o d.exr; mkstream show c.exr | grep -q "FRAMES=39 RANGE=0:39 "
    [ "$(mkstream differ c.exr d.exr)" = 0 ]'
check 'and to several, and further' '
    mkstream frames 41 50 | ptaccum part_0.exr part_10.exr - -o c2.exr
    mkstream frames 51 63 | ptaccum c2.exr - -o c3.exr; [ "$(mkstream differ c3.exr all.exr)" = 0 ]'
check 'as a stream of sums, which goes on' '
    mkstream frames 40 43 | ptaccum c.exr - | mkstream show | sed "s/.*FRAMES=//; s/ .*//" | tr "\n" " " |
        grep -qx "40 41 42 43 "'
check 'the history names both runs' '
    strings c.exr | grep -q "mkstream frames 0 31" && strings c.exr | grep -q "mkstream frames 32 39"'
check_error 'frames that it holds' 1 '^ptaccum: stdin: frame 32 is in c.exr already, which continues with frame 40' '
    mkstream frames 32 39 | ptaccum c.exr - -o c.exr'
check_error 'a run from frame 0' 1 'frame 0 is in c.exr already, which continues with frame 40' '
    mkstream frames 0 45 | ptaccum c.exr - -o c.exr'
check_error 'a hole' 1 'frames 40 to 41 are missing' 'mkstream frames 42 45 | ptaccum c.exr - -o c.exr'
check_error 'another seed' 1 'frame 40 has another seed than c.exr' '
    mkstream frames 40 45 16 16 7 | ptaccum c.exr - -o c.exr'
check_error 'a sum with holes' 1 'several seeds or holes' '
    ptaccum part_0.exr part_41.exr -o h.exr; mkstream frames 64 65 | ptaccum h.exr - -o x.exr'
check_error 'a sum that lost frame 0' 1 'has frame 0 summed in' '
    ptaccum -last n8.hdr -o n.hdr; mkstream numbers 9 10 | ptaccum n.hdr -'
check 'refused frames left the sum as it was' 'mkstream show c.exr | grep -q "FRAMES=39 RANGE=0:39 "'

# Output
if [ -e /dev/full ]; then
    check_error 'a full disk on stdout' 2 '^ptaccum: stdout: cannot be written: No space left' '
        ptaccum n8.hdr > /dev/full'
    check_error 'a full disk as file' 2 'cannot be written: No space left' '
        ln -s /dev/full full.exr; ptaccum -last n8.hdr -o full.exr'
fi
check_error 'a file in no folder' 2 'no/where.exr: cannot be written: No such file' '
    ptaccum -last n8.hdr -o no/where.exr > out'
check_error 'an unknown ending is reported before the work' 1 '^ptaccum: out.jpg: the ending' '
    ptaccum n8.hdr -o out.jpg > out'
check 'a closed pipe is a quiet end, and the file is still written' '
    mkstream frames 0 500 64 64 | ptaccum -o final.exr -o - 2> said | head -c 100000 > some
    [ ! -s said ] && mkstream show final.exr | grep -q "^64x64 FRAMES="'
check 'a reader that has enough ends the pipe at once, also when the next sum is far' '
    timeout 20 mkstream frames 0 100000000 | timeout 20 ptaccum -every x1000000 | head -c 2000 > some'
check_exit 'a signal before the first frame ends with status 3 and leaves no file' 3 '
    mkfifo wait; exec 9<> wait; ptaccum -o late.exr < wait > s & sleep .3; kill -TERM $!; wait $!'
check 'no file was left' '! ls -A | grep -E "late|tmp"'
formats() { grep -a "^FORMAT=" "$1" | sort -u | tr "\n" " "; }
check 'a picture by itself is RGBE, a stream float; -ff and -fc override' '
    ptaccum -last n8.hdr -o a.hdr -o - > b.hdr; ptaccum n8.hdr > c.hdr
    [ "$(formats a.hdr)$(formats b.hdr)$(formats c.hdr)" = \
        "FORMAT=32-bit_rle_rgbe FORMAT=32-bit_rle_rgbe FORMAT=float " ]
    ptaccum -last -ff n8.hdr -o a.hdr -o - > b.hdr; ptaccum -fc n8.hdr > c.hdr
    [ "$(formats a.hdr)$(formats b.hdr)$(formats c.hdr)" = "FORMAT=float FORMAT=float FORMAT=32-bit_rle_rgbe " ]'
check 'a merge and a conversion are pictures by themselves' '
    ptaccum part_0.exr part_10.exr > a.hdr; ptaccum a.hdr > b.hdr;
    [ "$(formats a.hdr)$(formats b.hdr)" = "FORMAT=32-bit_rle_rgbe FORMAT=32-bit_rle_rgbe " ]'
check 'a partial sum is float in any file, for it may be negative' '
    ptaccum part_10.exr -o a.hdr -o - > b.hdr; [ "$(formats a.hdr)$(formats b.hdr)" = "FORMAT=float FORMAT=float " ]
    mkstream differ a.hdr part_10.exr | grep -qx 0'
check 'with -o nothing goes to stdout, whatever the inputs are' '
    for k in 0 1 2; do mkstream numbers $k $k > fr$k.hdr; done
    ptaccum fr?.hdr -o s.exr > s0; ptaccum -last fr?.hdr -o s.exr | cat > s1;
    mkstream numbers 0 2 | ptaccum -every 1 -o s.exr | cat > s2
    ptaccum part_0.exr part_10.exr -o s.exr > s3; ptaccum a.hdr -o s.exr > s4;
    [ ! -s s0 ] && [ ! -s s1 ] && [ ! -s s2 ] && [ ! -s s3 ] && [ ! -s s4 ]'
check '-o - puts it there, too' '
    ptaccum fr?.hdr -o - -o s.exr | mkstream show | tail -1 > is;
    ptaccum part_0.exr -o - -o s2.exr | mkstream show >> is
    mkstream show s.exr | diff - <(head -1 is) && [ -e s2.exr ] && [ "$(wc -l < is)" = 2 ]'
check 'several files at once, and a sum may be converted' '
    ptaccum -last n8.hdr -o m.exr -o m.png; ptaccum m.exr -tone falsecolor -max 5000 -decades 3 -o m2.png
    for f in m.png m2.png; do [ "$(head -c 4 $f | tail -c 3)" = PNG ]; done'
check 'one dash and two, help on stdout' '
    ptaccum -help | grep -q -- -every && ptaccum --help > /dev/null && ptaccum --every 2 n8.hdr > s'
unsigned() { sed '/^ptaccum /d; /^CAPDATE=/d' "$@"; }  # without the lines that say what was typed, and when
check 'options as CLI11 took them, and @file' '
    ptaccum -last n8.hdr | unsigned > s; ptaccum n8.hdr --last | unsigned | cmp - s
    ptaccum --every=3 n8.hdr | unsigned > t; ptaccum -every=3 n8.hdr | unsigned | cmp - t
    ptaccum n8.hdr -last -ojoined.hdr; unsigned joined.hdr | cmp - s
    echo "-last n8.hdr" > words && ptaccum @words | unsigned | cmp - s'
check_error 'an unknown option' 1 '^ptaccum: -foo: unknown option; ptaccum -help lists them$' 'ptaccum -foo'
check_error 'and the nearest one is named' 1 '^ptaccum: -nolegned: unknown option; did you mean -nolegend[?]$' '
    ptaccum -nolegned'
check_error 'an unknown curve' 1 '^ptaccum: -tone: "sepia" is not one of photo, linear, grey, falsecolor$' '
    ptaccum -tone sepia n8.hdr'
check_error 'a luminance of 0' 1 '^ptaccum: -max: 0 is not above 0$' 'ptaccum -max 0 n8.hdr'
check_error 'an interval that is not a number' 1 '^ptaccum: -every: "often" is not an integer' '
    ptaccum -every often n8.hdr'

# What people look at
check 'PNG files of frames are filtered, and say so; no other file is' '
    mkstream frames 0 20 > f.str; ptaccum -o lit.png -o lit.exr -last < f.str
    ptaccum -filter none -o raw.png -o raw.exr -last < f.str
    grep -aq "FILTERED= non-local means" lit.png; grep -aq "FILTERED= no$" raw.png; not cmp -s lit.png raw.png
    [ "$(mkstream differ lit.exr raw.exr)" = 0 ]'
check 'the same bytes again, with any number of threads' '
    export SOURCE_DATE_EPOCH=1; for k in 1 2; do ptaccum -o p.png < f.str; mv p.png p$k.png; done; cmp p1.png p2.png
    taskset -c 0 ptaccum -o p.png < f.str; cmp p1.png p.png'
check 'too few frames and pictures on disk are shown as they are' '
    mkstream frames 0 3 | ptaccum -o few.png; ptaccum lit.exr -o disk.png
    grep -aq "FILTERED= no$" few.png && grep -aq "FILTERED= no$" disk.png'
