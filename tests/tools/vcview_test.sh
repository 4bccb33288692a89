# SPDX-License-Identifier: BSD-3-Clause
# vcview from outside: bytes and status pass, the page answers those who know its address.  A browser is asked in
# browser.sh.
. "${TOP:?}/tests/lib.sh"
needs vcview ptaccum mkstream vcmetrics python3

mkstream frames 0 4 > frames.str
ptaccum -every 1 < frames.str > sums.str

check 'without a program the pictures pass, byte by byte' 'vcview < sums.str 2> said | cmp - sums.str
    grep -qE "^vcview: http://127.0.0.1:[0-9]+/#[0-9a-f]{32}$" said'
check 'with a program its output passes, and its status' '
    vcmetrics -metrics Ev < sums.str > alone; vcview -- vcmetrics -metrics Ev < sums.str 2> /dev/null |
        cut -f 1,3 > through; cut -f 1,3 alone | cmp - through
    status=0; vcview -- sh -c "cat > /dev/null; exit 7" < sums.str 2> /dev/null || status=$?; test $status = 7'
check 'a program that has seen enough ends the pipe' '
    (yes || true) | vcview -- head -c 10 2> /dev/null | wc -c | grep -qx 10'
check_error 'a program that is not there' 2 '^vcview: no-such-program: ' 'vcview -- no-such-program < sums.str'
check_error 'an operand' 1 '^vcview: sums.str: is no option' 'vcview sums.str'
check_error 'no program after the dashes' 1 '^vcview: --: names no program' 'vcview -- < sums.str'
check_error 'an address that is none' 1 '^vcview: -listen: ' 'vcview -listen nowhere < sums.str'
check 'pictures that are no floats pass, and a warning says that the page does not show them' '
    ptaccum -last < frames.str > one.hdr; vcview < one.hdr 2> said | cmp - one.hdr; grep -q "no floats" said'

# ask PATH [header value]...: status, then the body, of a question to the vcview that runs
cat > ask.py << 'END'
import http.client, re, sys, time
for _ in range(100):
    found = re.search(r"http://127.0.0.1:(\d+)/#(\w+)", open("link").read())
    if found: break
    time.sleep(.05)
port, token = int(found[1]), found[2]
headers = dict(zip(sys.argv[2::2], sys.argv[3::2]))
if "X-Luxpipe-Token" not in headers and "no-token" not in headers: headers["X-Luxpipe-Token"] = token
method = headers.pop("method", "GET")
c = http.client.HTTPConnection("127.0.0.1", port, timeout=30)
c.request(method, sys.argv[1], headers=headers, body=headers.pop("body", None))
r = c.getresponse()
print(r.status)
for name in ("Content-Security-Policy", "Access-Control-Allow-Origin"):
    if r.getheader(name): print(name, r.getheader(name))
print(r.read().decode("latin1"))
END
mkfifo ctl
: > link
(cat sums.str; sleep 30) | TMPDIR=/nowhere vcview -control ctl -- vcmetrics -metrics Ev > lines 2> link &
running=$!
ask() { python3 ask.py "$@"; }
status_of() { ask "$@" | head -n 1; }
check 'the page is there for everybody who can reach it, with a strict policy' '
    ask / no-token 1 > page; head -n 1 page | grep -qx 200; grep -q "Content-Security-Policy default-src .none." page
    ! grep -q Access-Control page'
check 'news is for those who know the token' '
    test "$(status_of "/next" no-token 1)" = 401; test "$(status_of "/next" X-Luxpipe-Token 00)" = 401
    ask "/next?picture=0&line=0" > news; head -n 1 news | grep -qx 200; grep -aq "\"width\":" news'
check 'the picture is saved without a folder for temporary files' '
    ask "/save?as=exr" > exr; grep -qx 200 exr; grep -aq radianceHeader exr; ask "/save?as=hdr" | grep -aq RADIANCE'
check 'not for pages of other sites, nor under a foreign name' '
    test "$(status_of /next Origin http://evil.example)" = 403; test "$(status_of /next Host evil.example)" = 403'
check 'all lines arrive' '
    for k in 1 2 3 4 5 6 7 8 9; do [ "$(wc -l < lines)" = 6 ] || sleep .3; done
    ask "/next?picture=0&line=0" | grep -aq "\"line\":6"'
check 'a command that nobody reads is an answer, one that somebody reads arrives' '
    test "$(status_of /control method POST body next)" = 409
    timeout 20 head -n 1 ctl > got & sleep .5; test "$(status_of /control method POST body next)" = 204; wait $!
    grep -qx next got'
check 'other methods, other paths, long bodies' '
    test "$(status_of / method PUT)" = 405; test "$(status_of /control)" = 405; test "$(status_of /nothing)" = 404
    test "$(status_of /control method POST body "$(head -c 100000 /dev/zero | tr "\0" x)")" = 413'
kill $running 2> /dev/null
