# SPDX-License-Identifier: BSD-3-Clause
# What the live page costs and how fast it is: live_page.py BIN [ROUNDS]   (office, -ab 5; Chromium and selenium)
#   pointer: from a pointer that moves (-drag look around-) to the preview painted, by the browser's own clock
#   bare preview, bare frames: a ptrace that starts and writes them, beside it
#   tone: falsecolor, tone curves, contours and zoom, from the change to the canvas
#   open: from the page's address to its first picture
#   pace: frames a second of ptrace | ptaccum | vcmetrics, as a share of those without vcview, in turns: with vcview,
#   with a client that reads all, with Chromium beside, with hostile clients (a hundred bad requests a second and 200
#   connections that read nothing), and how long a good client then waits
# Tab separated: what, pixels a side, median, 95th percentile, number.
import http.client, os, re, socket, subprocess, sys, tempfile, threading, time
from pathlib import Path

top = Path(__file__).resolve().parent.parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(top / 'tests' / 'tools'))
from browser_page import Keys, Page, link_in, soon

rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 5
os.environ['PATH'] = f'{Path(sys.argv[1]).resolve()}:{os.environ["PATH"]}'
os.chdir(tempfile.mkdtemp())
os.system(f'cp {top}/examples/scenes/office/*.rad {top}/examples/scenes/office/view.vf {top}/examples/office.regions .')
scene = 'materials.rad layout.rad sky_day.rad'


def row(what, side, values):
    v = sorted(values)
    print(what, side, *(f'{v[min(len(v) - 1, int(q * len(v)))]:.4g}' if v else 'nan' for q in (.5, .95)), len(v),
          sep='\t', flush=True)


def bare(side):
    begin = time.time()
    subprocess.run(f'ptrace -w- -ab 5 -vf view.vf -x {side} -y {side} -frames 2 {scene} > bare', shell=True, check=True)
    return time.time() - begin


def page_rows(side):
    for name in ('lines', 'link'):
        if os.path.exists(name): os.remove(name)
    live = subprocess.Popen(f'exec luxpipe-live -ab 5 -vf view.vf -x {side} -y {side} -regions office.regions {scene} '
                            '> lines 2> link', shell=True)
    soon(lambda: os.path.exists('lines') and os.path.getsize('lines'), 60)
    page = None
    try:
        page = Page(link_in('link'))
        measure_page(page, side)
    finally:
        if page: page.chrome.quit()
        live.terminate()
        live.wait()


def measure_page(page, side):
    page.chrome.set_script_timeout(120)
    opened = []
    for _ in range(8):
        page.chrome.refresh()
        page.until('performance.getEntriesByName("picture").length > 0')
        opened.append(page.js('performance.getEntriesByName("picture")[0].startTime / 1000'))
    row('open', side, opened)
    if page.find('.menu'): page.menu('View')
    page.one('#drag').send_keys('look')
    page.chrome.execute_async_script('''
        const done = arguments[arguments.length - 1];
        const c = document.getElementById('canvas'), box = c.getBoundingClientRect();
        c.setPointerCapture = () => {};
        const send = (type, k) => c.dispatchEvent(new PointerEvent(type, { pointerId: 1, bubbles: true,
            clientX: box.left + box.width * (.5 + .2 * Math.sin(k / 40)), clientY: box.top + box.height * .5 }));
        performance.clearMeasures();
        send('pointerdown', 0);
        const begin = performance.now();
        let k = 0;
        const timer = setInterval(() => {
            send('pointermove', ++k);
            if (performance.now() < begin + 10000) return;
            clearInterval(timer);
            send('pointerup', k);
            done();
        }, 16);''')
    shown = page.js('performance.getEntriesByName("preview").map((e) => [e.startTime, e.duration / 1000])')
    row('pointer', side, [d for _, d in shown])
    if len(shown) > 1: row('previews a second', side, [1000 * (len(shown) - 1) / (shown[-1][0] - shown[0][0])])
    row('bare preview', side, [bare(128) for _ in range(9)])
    row('bare frames 0 and 1', side, [bare(side) for _ in range(9)])
    soon(lambda: page.js('document.getElementById("status").textContent').startswith(f'{side} '), 60)
    measured = "performance.getEntriesByName('tone').map((e) => e.duration / 1000)"
    for tone in ('falsecolor', 'photo', 'grey', 'linear'):
        row(f'tone {tone}', side, page.js(f'''(() => {{
            const s = document.getElementById('tone');
            s.value = '{tone}';
            performance.clearMeasures('tone');
            for (let k = 0; k < 20; k++) s.dispatchEvent(new Event('change'));
        }})()''') or soon(lambda: page.js(measured + '.length') >= 20) and page.js(measured))
    row('zoom', side, page.js('''(() => {
        const c = document.getElementById('canvas'), box = c.getBoundingClientRect(), all = [];
        for (let k = 0; k < 40; k++) {
            const start = performance.now();
            c.dispatchEvent(new WheelEvent('wheel',
                { deltaY: k < 20 ? -30 : 30, clientX: box.left + 99, clientY: box.top + 99 }));
            all.push((performance.now() - start) / 1000);
        }
        return all;
    })()'''))


class Client:
    """Asks the page's server until it is stopped."""
    def __init__(self, work):
        found = re.search(r'http://127.0.0.1:(\d+)/#(\w+)', open('link').read())
        self.port, self.token, self.on, self.waits = int(found[1]), found[2], True, []
        self.thread = threading.Thread(target=work, args=(self,))
        self.thread.start()

    def ask(self, path, **headers):
        c = http.client.HTTPConnection('127.0.0.1', self.port, timeout=30)
        try:
            c.request('GET', path, headers={'X-Luxpipe-Token': self.token, **headers})
            return c.getresponse().read()
        finally:
            c.close()

    def read(self):
        news = {'picture': 0, 'line': 0, 'files': 0}  # as the page asks
        while self.on:
            try:
                body = self.ask('/next?' + '&'.join(f'{name}={k}' for name, k in news.items()))
            except (OSError, http.client.HTTPException):
                return  # the pipe has ended
            if b'"ended"' in body: return
            for name in news:
                found = re.search(rb'"%s":(\d+)' % name.encode(), body[:99])
                news[name] = int(found[1]) if found else news[name]

    def attack(self):
        crowd = [socket.create_connection(('127.0.0.1', self.port)) for _ in range(200)]
        for s in crowd[::2]: s.sendall(f'GET /next?picture=0 HTTP/1.1\r\nHost: localhost\r\nX-Luxpipe-Token: '
                                       f'{self.token}\r\n\r\n'.encode())
        for k in range(10**9):
            if not self.on: break
            try:
                if k % 20 == 0:
                    begin = time.time()
                    self.ask('/facts')
                    self.waits.append(time.time() - begin)
                elif k % 2: self.ask('/next', Host='evil.example')
                else: self.ask('/pixel?x=1e300&y=-1', **{'X-Luxpipe-Token': 'x' * 30000})
            except (OSError, http.client.HTTPException):
                pass
            time.sleep(.01)
        for s in crowd: s.close()

    def stop(self):
        self.on = False
        self.thread.join()


def pace(side, through, begin=None):
    """Seconds of a frame, by the table's own clock."""
    if os.path.exists('link'): os.remove('link')
    frames = 25 if side > 300 else 61
    pipe = subprocess.Popen(f'ptrace -w- -ab 5 -vf view.vf -x {side} -y {side} -frames {frames} {scene} | '
                            f'ptaccum -every x2/16 | {through}vcmetrics -ci 95 -metrics Ev,DGP > lines 2> link',
                            shell=True)
    client = None
    if begin:
        soon(lambda: os.path.exists('link') and 'http' in open('link').read(), 60)
        client = begin()
    pipe.wait()
    if isinstance(client, Client): client.stop()
    lines = [line.split('\t') for line in open('lines').read().splitlines()[1:]]
    return (float(lines[-1][1]) - float(lines[0][1])) / (int(lines[-1][0]) - int(lines[0][0])), client


def pace_rows(side):
    shares, waits = {}, []
    page = Page('about:blank')
    page.chrome.get('about:blank')
    live = 'vcview -- '
    for _ in range(rounds):
        bare, _ = pace(side, '')
        for name, begin in (('vcview', None), ('a client', lambda: Client(Client.read)),
                            ('hostile clients', lambda: Client(Client.attack)),
                            ('Chromium', lambda: page.chrome.get(link_in('link')))):
            seconds, client = pace(side, live, begin)
            shares.setdefault(name, []).append(bare / seconds)
            if name == 'hostile clients': waits += client.waits
            page.chrome.get('about:blank')
    for name, all in shares.items(): row(f'pace with {name}', side, all)
    row('a good client waits', side, waits)
    page.chrome.quit()


print('what\tside\tmedian\t95th\tnumber')
for side in (256, 512): pace_rows(side)
for side in (256, 512): page_rows(side)
