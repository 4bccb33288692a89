# SPDX-License-Identifier: BSD-3-Clause
# Two windows that change two files at random, as the page does: vcview_design.py LINK GOT FILE FILE
#   GOT: what arrives in the FIFO.  A sentence for each check; status 1 if one fails.
import json, random, re, struct, sys, time, urllib.error, urllib.parse, urllib.request

for _ in range(200):
    found = re.search(r'(http://[^/]+)/#(\w+)', open(sys.argv[1]).read())
    if found: break
    time.sleep(.05)
host, token = found.groups()
names, failures, dice = sys.argv[3:], 0, random.Random(7)


def check(sentence, true, more=''):
    global failures
    failures += not true
    print('ok' if true else 'not ok', '-', sentence, '' if true else more)


def ask(path, method='GET', body=None):
    request = urllib.request.Request(host + path, method=method, data=body, headers={'X-Luxpipe-Token': token})
    try:
        with urllib.request.urlopen(request, timeout=30) as answer:
            return answer.status, answer.read(), (answer.headers.get('ETag') or '').strip('"')
    except urllib.error.HTTPError as e:
        return e.code, e.read(), ''


def state():
    body = ask('/next?picture=9999&line=9999')[1]
    return json.loads(body[4:4 + struct.unpack('<I', body[:4])[0]])['state']


class Window:
    """What one window knows of each file: its text and the version of it; and the state of the list of changes."""
    def __init__(self): self.known, self.state = [None] * len(names), None

    def read(self, n):
        status, text, version = ask(f'/overlay?n={n}')
        self.known[n] = (text if status == 200 else open(names[n], 'rb').read(), version)

    def send(self, n, text, going=''):
        question = urllib.parse.urlencode(
            {'n': n, 'version': self.known[n][1], 'said': f'to {text[:20]}\n', 'going': going})
        status, _, version = ask(f'/overlay?{question}', 'POST', text)
        if status == 200: self.known[n] = (text, version)
        return status


def undo(state): return ask(f'/undo?state={state}', 'POST', b'')[0]


windows, model, undone = [Window(), Window()], [open(n, 'rb').read() for n in names], []
fresh = [[False] * len(names) for _ in windows]
stale = wrong = 0
for k in range(200):
    w, n = dice.randrange(2), dice.randrange(len(names))
    if windows[w].known[n] is None or dice.random() < .3:  # reloaded, or it has heard of the change
        windows[w].read(n)
        fresh[w][n] = True
    if dice.random() < .2:
        now = state()['steps'][0]
        if dice.random() < .7: windows[w].state = now
        want = 412 if windows[w].state != now else 204 if undone else 409
        wrong += undo(windows[w].state) != want
        if want == 204:
            m, model[m] = undone[-1][0], undone.pop()[1]
            fresh[0][m] = fresh[1][m] = False
    else:
        text = f'{k} {dice.random()}\n'.encode() * dice.randrange(1, 40)
        status = windows[w].send(n, text)
        wrong += status != (200 if fresh[w][n] else 412)
        stale += status == 412
        if status == 200:
            undone.append((n, model[n]))
            model[n] = text
            fresh[1 - w][n] = False
    if not fresh[w][n]:  # it is told, and shows the other one's
        windows[w].read(n)
        fresh[w][n] = True
        wrong += windows[w].known[n][0] != model[n]
check('a change of an old version is refused, any other is taken', not wrong and stale > 10, (wrong, stale))
third = Window()
for n in range(len(names)): third.read(n)
check('a window that comes later has the texts of the model', [k[0] for k in third.known] == model)
for _ in range(100):  # all that was sent has arrived
    size = len(open(sys.argv[2], 'rb').read())
    time.sleep(.1)
    if size == len(open(sys.argv[2], 'rb').read()): break
got = open(sys.argv[2], 'rb').read()
last = {}
for found in re.finditer(rb'(?:note [^\n]*\n)?overlay (\S+) (\d+|-)\n', got):
    size = 0 if found[2] == b'-' else int(found[2])
    last[found[1].decode()] = got[found.end():found.end() + size] if found[2] != b'-' else None
check('and so has ptrace', all(last[n] == m or (last[n] is None and m == open(n, 'rb').read())
                               for n, m in zip(names, model)))
check('words for an edit are one line before it', len(re.findall(rb'note to [^\n]*\noverlay ', got)) > 50 and
      not re.search(rb'note [^\n]*[\x00-\x09\x0b-\x1f]', got))

first = windows[0]
first.read(0)
open(names[0], 'w').write('by an editor\n')
time.sleep(1)
check('after an editor has written the file, a change from before is refused', first.send(0, b'mine') == 412)
first.read(0)
check('what the editor wrote counts', first.known[0][0] == b'by an editor\n' and state()['texts'][0][1] is False)
before = model[0]
check('and Undo brings back what was typed', undo(state()['steps'][0]) == 204)
first.read(0)
check('all of it', first.known[0][0] == before)
check('no version, no change', ask('/overlay?n=0', 'POST', b'x')[0] == 412 and ask('/undo', 'POST', b'')[0] == 412)
texts = lambda: [first.read(n) or first.known[n][0] for n in range(2)]
kept = texts()
ask('/variant?do=keep&name=V', 'POST', b'')
for n in range(2): first.send(n, b'other')
check('a variant shows its texts', ask('/variant?do=show&name=V', 'POST', b'')[0] == 204 and texts() == kept, texts())
check('and one Undo brings both back', undo(state()['steps'][0]) == 204 and texts() == [b'other'] * 2, texts())
check('the next one of one text', undo(state()['steps'][0]) == 204 and texts() == [b'other', kept[1]], texts())
ask('/control', 'POST', b'pause\n')
check('every window knows of a pause', state()['paused'])
ask('/control', 'POST', b'preview -vp 1 1 1\n')
time.sleep(4)
check('a window that is gone while it moves leaves no small picture behind',
      open(sys.argv[2], 'rb').read().endswith(b'go\n'))
ask('/control', 'POST', b'pause\n')
first.read(0)
first.send(0, b'go on')
check('which a change ends', not state()['paused'])
check('a view before the first is none', ask('/back', 'POST', b'')[0] == 409)
sys.exit(failures > 0)
