# SPDX-License-Identifier: BSD-3-Clause
# Camera, sliders and the table of edits in the page of vcview: browser_model.py LINK GOT SIZE
#   LINK: what vcview printed; GOT: what arrives in the FIFO; SIZE: sides of the square picture.
import os, re, sys
import xml.etree.ElementTree as xml
from selenium.webdriver.common.keys import Keys
from browser_page import Page, check, link_in, soon

size = (int(sys.argv[3]),) * 2
page = Page(link_in(sys.argv[1]))
got = lambda: open(sys.argv[2]).read()
arrives = lambda words: soon(lambda: re.search(words, got()))
numbers = lambda line: [float(v) for v in re.findall(r'-?[\d.]+(?:e-?\d+)?', line)]

# before and after, as the program's columns say it
check('there is a row for each edit', soon(lambda: len(page.rows('#edits')) == 4))
heads = lambda: page.text('#edits thead').split()
check('which has glare alone', heads() == ['edit', 'frames', 'DGP'], heads())
page.click('#edits-more')
check('and more on demand', heads()[2:4] == ['Ev', 'DGP'], heads())
rows = [' '.join(row) for row in page.rows('#edits')]
check('less glare is better', 'better' in rows[0] and '−0.05' in rows[0], rows[0])
check('more glare is worse', 'worse' in rows[1], rows[1])
check('an interval that holds 0 tells nothing apart', 'not told apart yet' in rows[2], rows[2])
words = page.chrome.execute_async_script('''
    const done = arguments[arguments.length - 1];
    Promise.all([import('/judge.js'), import('/verdict.js')]).then(([{ glare_of, judged, verdict },
        { glare_now, state_of }]) => {
        const row = (value, d, low, high, half = .001) => ({ DGPf: value, 'DGPf.lo': value - half,
            'DGPf.hi': value + half, 'DGPf.d': d, 'DGPf.d.lo': low, 'DGPf.d.hi': high });
        const far = row(.3, -.03, -.04, -.02), near = row(.3, -.008, -.009, -.007);
        const other = row(.348, -.004, -.005, -.003), then = row(.352), wide = row(.352, 0, 0, 0, .003);
        const lines = (row) => ({ columns: ['DGPf', 'DGPf.lo'], rows: [row] }), none = { frame: 1, DGPf: .34 };
        const said = ({ text, number, small }) => [text, number, small ?? false].join('; ');
        const now = (row, state) => said(glare_now(lines(row), state));
        done([[far, null, 'overlay', .01], [far, null, 'view', .01], [near, null, 'overlay', .01],
            [other, then, 'overlay', .01], [far, null, 'overlay', .05]]
            .map((question) => judged('DGPf', ...question).text).concat([
            state_of({ lost: true }), state_of({ ended: 3, since: 1 }), state_of({ paused: true, since: 1 }),
            state_of({ since: 40 }), state_of({ since: 1, settled: 38 }),
            verdict('DGPf', { DGPf: .36, 'DGPf.lo': .345, 'DGPf.hi': .37 }).text,
            verdict('DGPf', { frame: 4, Ev: 0, DGPf: .2 }).text + verdict('DGPf', { frame: 0, Ev: 0, DGPf: .2 }).number,
            verdict('DGPf', { frame: 4, Ev: 0, DGPf: .2 }).number, glare_of(['DGPf', 'DGP'], { DGP: .3 }),
            judged('DGPf', other, wide, 'overlay', .01).text, judged('DGPf', other, null, 'overlay', .01).text,
            verdict('DGPf', { DGPf: .36, 'DGPf.lo': .34, 'DGPf.hi': .41 }).text, verdict('DGPf', none).text,
            now(none, {}), now(none, { first: far }), now(far, { waits: true }), now(far, { waits: true, first: then }),
            now(then, { first: far }), now(none, { first: row(.36, 0, 0, 0, .06) }), verdict('DGPf', far).told]));
    });''')
check('better is a word for another class or for more than the threshold, never for a view',
      words[:5] == ['better', 'lower', 'lower', 'better', 'lower'], words)
check('what the programs do is said in words', all(w in said for w, said in zip(
    ('lost', 'status 3', 'paused', 'no picture for 40 s', 'settled after 38 frames'), words[5:10])), words)
check('two classes where the interval holds both', words[10] == '◔ imperceptible to perceptible', words)
check('a black picture has no class, and the likely reasons', words[11] == '' and 'it is night' in words[12], words)
check('pictures without moments have DGP', words[13] == 'DGP', words)
check('another class counts only where both intervals lie in one class each', words[14:16] == ['lower', 'lower'], words)
check('no class before an interval lies in two neighbouring ones', words[16:18] == ['looking …'] * 2, words)
check('nor in the head of the page', words[18] == 'looking …; ; false', words)
check('a small picture says it first', words[19] == '○ imperceptible; DGPf .300 (.299 to .301); true', words)
check('numbers of an earlier model say nothing of this one', words[20] == 'looking …; ; false', words)
check('those of a small picture do', words[21] == '◔ perceptible; DGPf .352 (.351 to .353); true', words)
check('until the large one has its own', words[22] == '◔ perceptible; DGPf .352 (.351 to .353); false', words)
check('an interval that is too wide is shown without a class',
      words[23] == 'looking …; DGPf .360 (.300 to .420); true', words)
check('DGP is told as a share of people, with the class that the standard gives it',
      '30 of 100' in words[24] and 'below 35 of 100 imperceptible' in words[24], words[24])
verdicts = open(os.path.join(os.environ['TOP'], 'tests/golden/verdicts.tsv'))
told = [line.rstrip('\n').split('\t') for line in verdicts if not line.startswith('#')]
said = page.chrome.execute_async_script('''
    const [rows, done] = arguments;
    import('/judge.js').then(({ verdict }) => done(rows.map(([value, low, high]) => {
        const { text, told } = verdict('DGP', { DGP: Number(value), 'DGP.lo': Number(low), 'DGP.hi': Number(high) });
        return [text === 'looking …' ? '-' : text.slice(2), told];
    })));''', told)
check('the words are those of the report', said == [row[3:] for row in told], said)
check('illuminance is higher or lower', 'lower' in rows[1] and 'higher' in rows[0], rows)
drawn = lambda: page.js('document.querySelector("#plots svg").textContent')
meant = lambda row: page.js(f'document.querySelectorAll("#table tbody tr")[{row}].title')
check('metrics have their meaning and unit', 'glare probability' in meant(1) and page.rows('#table')[0][4] == 'lx',
      (meant(1), page.rows('#table')))
check('and plots have axes in words', 'frames' in drawn() and 'lx' in drawn(), drawn())
check('earlier edits are ghosts in the plots', len(page.find('#plots figure:first-child path.ghost')) == 3)
check('the stop is marked', len(page.find('#plots figure:first-child line.stop')) == 1)

# round numbers of scales
scales = page.chrome.execute_async_script('''
    const done = arguments[arguments.length - 1];
    import('/scale.js').then(({ round_steps }) => done([round_steps(9, 9070, true, 9), round_steps(20, 110, true),
        round_steps(0, 330, false), round_steps(5, 5, false)]));''')
check('scales have round numbers', scales == [
    [10, 20, 50, 100, 200, 500, 1000, 2000, 5000][:9], [20, 50, 100], [0, 100, 200, 300], []], scales)

# what lies outside of a plot's axes is not drawn, and a name is text in the file as well
spikes = page.chrome.execute_async_script('''
    const done = arguments[arguments.length - 1];
    import('/plot.js').then(({ plot }) => {
        const rows = [...Array(40).keys()].map((k) =>
            ({ frame: k + 1, Ev: 100, 'Ev.lo': k ? 99 : -1e6, 'Ev.hi': k ? 101 : 1e6 }));
        const figure = document.getElementById('plots').appendChild(document.createElement('figure'));
        figure.append(plot('Ev', [{ rows }]));
        const area = figure.querySelector('svg svg'), band = area.querySelector('.interval');
        const ys = band.getAttribute('d').match(/,-?[\\d.]+/g).map((y) => Number(y.slice(1)));
        done([Math.min(...ys), Math.max(...ys), getComputedStyle(area).overflow]);
        figure.remove();
    }).catch((e) => done([String(e)]));''')
check('values outside of the axes are cut off, not drawn at the edge',
      len(spikes) == 3 and spikes[0] < -100 and spikes[1] > 200 and spikes[2] == 'hidden', spikes)
sheet = xml.fromstring(page.chrome.execute_async_script('''
    const done = arguments[arguments.length - 1];
    import('/save.js').then(({ plots_svg }) => done(plots_svg()));'''))
names = [e.text for e in sheet]
check('names in the saved plots are text', 'a<b>&"c.TAL' in names, names)

# counts of arguments are no numbers to change
numbers_in = lambda text: page.chrome.execute_async_script('''
    const [text, done] = arguments;
    import('/model_text.js').then(({ numbers_in }) =>
        done(numbers_in(text).map((n) => text.slice(n.start, n.end) + (n.whole ? '!' : ''))));
    ''', text)
for text, want in (
        ('void light l 0 0 3 7 8 9', '7 8 9'), ('void plastic m\n0\n0\n5 .1 .2 .3 0 0 # 4\n', '.1 .2 .3 0 0'),
        ('l sphere s 0 0 4 1 2 3 4 m ring r 0 0 8 0 0 4\n0 0 1 0 4', '1 2 3 4 0 0 4 0 0 1 0 4'),
        ('void alias a b\nvoid glass g 0 0 3\n.9 .8 .7', '.9 .8 .7'),
        ('!genbox m n.1 1 2 3 | xform -a 5 -t 0 0 4 \\\n -i 2\nvoid glass g 0 0 3 .9 .9 .9',
         '1 2 3 5! 0 0 4 2! .9 .9 .9'),
        ('void brightfunc f 4 f x.cal -s 2.5 0 2 .5 3', '2.5 .5 3'),
        ('!gensky 12 21 14:30 +s -a 42.36', '12 21 42.36'), ('# 1 2 3\n\n', '')):
    check(f'the numbers in {text!r}', ' '.join(numbers_in(text)) == want, numbers_in(text))

# camera
page.until('document.body.dataset.picture > 0')
page.keys('#canvas', 'w')
# at rest the full picture is asked for; a drag before that would replace it
check('w walks ahead', arrives(r'(?m)^view -vp 2 2\.[0-9]+ 1\.[0-9]+ -vd 0 -0\.99'), got())
page.menu('View')
page.keys('#drag', 'look')
page.drag(size, (size[0] * .5, size[1] * .5), (size[0] * .55, size[1] * .5), (size[0] * .6, size[1] * .5))
views = lambda: re.findall(r'^view -vp (.*) -vd (.*)$', got(), re.M)
check('dragging looks around: what was held stays under the pointer', soon(
    lambda: len(views()) >= 2 and abs(abs(numbers(views()[-1][1])[0]) - .309) < .02), views())
page.menu('View')
page.keys('#drag', 'orbit')
page.drag(size, (size[0] * .5, size[1] * .5), (size[0] * .6, size[1] * .5), (size[0] * .75, size[1] * .5))
check('dragging turns around what is ahead',
      soon(lambda: len(views()) >= 3 and abs(numbers(views()[-1][0])[0] - 2) > .3))
# degrees and named views
page.menu('View')
page.type('#azimuth', '135')
check('degrees turn the view', soon(lambda: len(views()) >= 4 and abs(numbers(views()[-1][1])[0] - .707) < .01 and
                                    abs(numbers(views()[-1][1])[1] + .707) < .01), views()[-1])
page.type('#place-name', 'desk')
page.click('#place-keep')
check('a view is kept under a name', soon(lambda: [b.text for b in page.find('#places button')] == ['desk', '×']))
page.click('#places button')
check('and asked for by it', arrives(r'(?m)^view  ?-vta -vp 2 2.7 1.2'), got()[-300:])
page.click('#places button', '×')
check('and deleted', soon(lambda: not page.find('#places button')))
page.menu('Save')
page.keys('#command-text', 'aim 2 1 1', Keys.ENTER)
check('words pass to the renderer', arrives(r'(?m)^aim 2 1 1$'), got())

# sliders
check('skies have sliders for day and hour', len(page.find('#skies input')) == 2)
page.keys('#skies label:nth-of-type(2) input', Keys.ARROW_RIGHT)
check('the hour arrives as a text for the file',
      arrives(r'overlay sky.rad \d+\n# a sky\n!gensky 12 21 14.25 \+s'), got())
page.click('#model-text button', '.2')
page.type('#model-number input[type=number]', '.35')
check('any number is changed', arrives(r'14\.25 \+s .* -g 0\.35\n'), got())
check('nothing is saved before it is asked for', '-g .2' in open('sky.rad').read())
sizes = [(int(n), len(t)) for n, t in
         re.findall(r'overlay sky.rad (\d+)\n((?:# a sky\n).*?)(?=overlay|view|preview|go|what|\Z)', got(), re.S)]
check('texts have the length that is announced', sizes and all(n == m for n, m in sizes), sizes)
page.click('#undo')
check('that is undone', soon(lambda: re.findall(r'-g (\S+)\n', got())[-1] == '.2'))
page.click('#model-save')
check('saved on demand', soon(lambda: '14.25 +s' in open('sky.rad').read()))
check('then there is nothing to save', soon(lambda: not page.one('#model-save').is_enabled()))

# Save twice, the second time while the first one is on its way
page.chrome.set_network_conditions(latency=500, download_throughput=1e9, upload_throughput=1e9)
for _ in range(2):
    page.keys('#skies label:nth-of-type(2) input', Keys.ARROW_RIGHT)
    page.click('#model-save')
check('both are saved', soon(lambda: '14.75 +s' in open('sky.rad').read()) and
      soon(lambda: page.one('#model-say').text == 'sky.rad is saved'), page.one('#model-say').text)
page.chrome.set_network_conditions(latency=0, download_throughput=1e9, upload_throughput=1e9)
soon(lambda: not page.one('#model-save').is_enabled())

# another program writes the file while a change of the page is not saved and the page has not heard of it
page.js('window.deaf = true')
page.keys('#skies label:nth-of-type(2) input', Keys.ARROW_RIGHT)
check('a change is there to save', soon(lambda: page.one('#model-save').is_enabled()) and arrives(r'12 21 15 \+s'),
      got()[-200:])
theirs = open('sky.rad').read() + '# by hand\n'
with open('sky.rad', 'w') as file: file.write(theirs)
page.click('#model-save')
check('Save leaves a file that another program has changed, and says so',
      soon(lambda: 'another program' in page.one('#model-say').text) and open('sky.rad').read() == theirs,
      open('sky.rad').read())
page.js('window.deaf = false')
check('the page shows that file', page.until("document.getElementById('model-text').textContent.includes('by hand')"))

page.check_keyboard()
page.check_contrast()
for w in (1280, 390):
    page.resize(w, 900)
    check(f'nothing is wider than a page of {w} pixels', page.fits())
page.end()
