# SPDX-License-Identifier: BSD-3-Clause
# Strangers and broken clients at vcview's port (vcview_hostile.py): the pipe goes on, nothing is told, nothing written.
. "${TOP:?}/tests/lib.sh"
needs vcview ptaccum mkstream python3

mkstream frames 0 4 > frames.str
ptaccum -every 1 < frames.str > sums.str
name='<img src=x onerror=alert(1)>.regions'
echo 'desk  circle view 20  # <script>alert(1)</script>' > "$name"
mkfifo ctl
sleep 1000 > ctl & reader=$!   # holds the FIFO, reads nothing
: > link
(cat sums.str; for ((k = 0; k < 400; k++)); do cat sums.str; sleep .05; done) |
    vcview -control ctl -regions "$name" -- sh -c 'cat > all; echo "<script>alert(1)</script>"' > lines 2> link &
running=$!
while ! command grep -q http link; do sleep .05; done
check 'strangers and broken clients' '
    python3 "$TOP/tests/tools/vcview_hostile.py" link "$(pgrep -P $$ -x vcview | head -n 1)" "$name" >&2'
kill $reader $running 2> /dev/null
wait $running 2> /dev/null
check 'the pipe went on meanwhile, byte by byte' '
    test "$(stat -c %s all)" -gt $((3 * $(stat -c %s sums.str))); head -c "$(stat -c %s sums.str)" all | cmp - sums.str'
check 'no other file was made' '
    there=$(ls -A | sort)
    printf "%s\n" "$name" .stderr .stdout all ctl frames.str lines link sums.str | sort | diff - <(echo "$there")'
