# SPDX-License-Identifier: BSD-3-Clause
# Strangers and broken clients at vcview's port: vcview_hostile.py LINK PID FILE
#   FILE: the one file that the page may write (-regions).  A sentence for each check; status 1 if one fails.
import http.client, re, socket, sys, threading, time

for _ in range(100):
    found = re.search(r'http://127.0.0.1:(\d+)/#(\w+)', open(sys.argv[1]).read())
    if found: break
    time.sleep(.05)
port, token, name = int(found[1]), found[2], sys.argv[3]
text, failures = open(name).read(), 0


def check(sentence, true, more=''):
    global failures
    failures += not true
    print('ok' if true else 'not ok', '-', sentence, '' if true else more)


def ask(path, method='GET', body=None, own=True, **headers):
    c = http.client.HTTPConnection('127.0.0.1', port, timeout=30)
    try:
        c.request(method, path, body=body, headers={**({'X-Luxpipe-Token': token} if own else {}), **headers})
        answer = c.getresponse()
        return answer.status, answer.read()
    except (ConnectionError, http.client.HTTPException) as e:
        return 0, str(e).encode()
    finally:
        c.close()


def raw(data, read=True):
    s = socket.create_connection(('127.0.0.1', port), timeout=30)
    try:
        s.sendall(data)
        return s.recv(200) if read else b''
    except OSError:
        return b''
    finally:
        s.close()


def memory():  # MB
    return int(re.search(r'VmRSS:\s+(\d+)', open(f'/proc/{sys.argv[2]}/status').read())[1]) / 1024


def kept(): return open(name).read() == text


def good():  # seconds until a client that may ask has its answer, the median of five
    times = []
    for _ in range(5):
        begin = time.time()
        assert ask('/facts')[0] == 200
        times.append(time.time() - begin)
    return sorted(times)[2]


paths = ['/next?picture=0&line=0', '/pixel?x=1&y=1', '/facts', '/file?n=0', '/outlines?n=0', '/sources', '/srgb',
         '/save?as=hdr', '/table?top=100']
check('without the secret nothing is told', all(ask(p, own=False) == (401, b'no\n') for p in paths))
check('nor with a wrong one', all(ask(p, own=False, **{'X-Luxpipe-Token': token[:-1] + 'x'})[0] == 401 for p in paths))
for header, value in (('Origin', 'http://evil.example'), ('Origin', 'null'), ('Host', 'evil.example'),
                      ('Host', f'127.0.0.1.evil.example:{port}'), ('Host', '')):
    check(f'nor where {header} is "{value}"', all(ask(p, **{header: value})[0] in (400, 403) for p in paths))
change = dict(method='PUT', body='x circle view 3\n', **{'If-Match': '"none"'})
check('nothing is written for them',
      ask('/file?n=0', own=False, **change)[0] == 401 and
      ask('/file?n=0', Origin='http://evil.example', **change)[0] == 403 and kept())
check('nor over a state that was not read', ask('/file?n=0', **change)[0] == 412 and
      ask('/file?n=0', 'PUT', 'x circle view 3\n')[0] == 412 and kept())
strange = ('1', '99', '-1', '1e300', '../x', '%00', 'x', 'nan', 'inf', '', '0x0', '0.0', '%200', '0%00', '1e-9',
           '00000000001')
check('nor to files that were not named',
      all(ask(f'/file?n={n}', **change)[0] == 404 for n in strange) and ask('/file', **change)[0] == 404 and kept())
check('nor are such shown', all(ask(f'/{q}?n={n}')[0] == 404 for n in strange for q in ('file', 'outlines')))
check('numbers that no integer holds are no pixel and no scale', all(
    ask(f'/pixel?x={n}&y=0')[0] == 404 and ask(f'/table?top=100&divisions={n}')[0] == 400
    for n in ('1e300', '-1e300', '4294967296', '-1', 'x')))
check('a path that holds a zero byte is not the one before it',
      all(ask(p, own=False)[0] in (400, 401, 404) for p in ('/main.js%00', '/%00', '/main.js%00.css')))
good_head = f'GET /facts HTTP/1.1\r\nHost: localhost\r\nX-Luxpipe-Token: {token}\r\n'
check('a header that counts comes once', all(
    raw(f'{good_head}{extra}\r\n\r\n'.encode()).split()[1] == b'400'
    for extra in ('Host: evil.example', 'host: localhost', 'X-Luxpipe-Token: x',
                  'Origin: http://localhost\r\nOrigin: http://evil.example')))
check('nor what is too long', ask('/file?n=0', 'PUT', b'#' * (2 << 20), **{'If-Match': '"none"'})[0] == 413 and kept())
check('no page of the server is another site\'s to read', b'Access-Control' not in raw(
    b'OPTIONS /next HTTP/1.1\r\nHost: localhost\r\nOrigin: http://evil.example\r\n\r\n'))

before = memory()
check('a megabyte of headers is refused', ask('/', **{'X-Long': 'x' * (1 << 20)})[0] in (0, 400, 413, 431, 494))
raw(b'GET / HTTP/1.1\r\nHost: localhost\r\n' + b'A: b\r\n' * 150000, read=False)
head = f'PUT /file?n=0 HTTP/1.1\r\nHost: localhost\r\nX-Luxpipe-Token: {token}\r\nContent-Length: 900\r\n\r\n'.encode()
raw(head + b'x circle', read=False)
check('a body that is cut changes nothing', kept())
for junk in (b'\0' * 5000, b'GET', b'GET / HTTP/9.9\r\n\r\n', b'\xff\xfe' * 3000 + b'\r\n\r\n',
             b'POST /control HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\nzzzz\r\n'):
    raw(junk, read=False)
check('and a good client has its answer at once', good() < 1)

# many that are connected, stop in the middle of a question, or do not read
crowd = []
for k in range(200):
    s = socket.create_connection(('127.0.0.1', port), timeout=30)
    if k % 2: s.sendall(b'GET /next?picture=0&line=0 HTTP/1.1\r\nHost: localhost\r\n')
    if k % 4 == 3: s.sendall(f'X-Luxpipe-Token: {token}\r\n\r\n'.encode())
    crowd.append(s)
check('among 200 connections as well', good() < 1, good())
threads = [threading.Thread(target=lambda: [ask(p) for p in paths if 'sources' not in p]) for _ in range(20)]
for t in threads: t.start()
for t in threads: t.join()
for s in crowd: s.close()

# more than there is room for, without the token: half a question each, then a byte now and then
crowd = []
for k in range(700):
    crowd.append(socket.create_connection(('127.0.0.1', port), timeout=30))
    crowd[-1].sendall(b'GET /main.js HTTP/1.1\r\nHost: local')
check('those without the token leave room for those with it', good() < 1, good())


def open_still(s):
    try:
        s.sendall(b'x')
        time.sleep(.01)
        s.sendall(b'x')
        return True
    except OSError:
        return False


left, begin = [s for s in crowd[-20:] if open_still(s)], time.time()
check('the newest of them wait for their question', len(left) == 20, len(left))
while left and time.time() < begin + 20:
    time.sleep(.5)
    left = [s for s in left if open_still(s)]
check('a question has its time, however it trickles', not left and time.time() < begin + 12,
      (len(left), time.time() - begin))
for s in crowd: s.close()
time.sleep(.5)
check('memory does not grow by more than what they were sent', memory() < before + 64, (before, memory()))
check('the file is as it was', kept())
sys.exit(failures > 0)
