// SPDX-License-Identifier: MIT
/* "Judge yours": somebody's functions, asked in a worker, row by row. */
import { $, element, grouped, hashOf, packed, short, startWorker, unpacked } from './base.js';
import { EXAMPLES } from './examples.js';

const PATIENCE = 5000; /* ms without a sign of life */

const ENTRIES = [
    ['unit', 'directions of length 1'],
    ['t_min=0', 'rays from their start on'],
    ['outside', 'rays that start outside'],
    ['local', 'the object at the origin, along z'],
    ['float', 'single precision'],
];
const ALLOWED = [
    ['touch=miss', 'a touch may be a miss'],
    ['surface=miss', 'a start on the surface may be a miss'],
    ['inside=miss', 'a start inside may be a miss'],
    ['end=miss', 'a hit at t_max may be a miss'],
    ['inside=0', 'from inside, t may be t_min'],
    ['decision', 'only hit or miss is told'],
];
const UNITS = {
    size: 'in sizes of the object', distance: 'in distances', length: 'in the scene’s unit',
    ulps: 'in ulps of the largest coordinate', none: 'none',
};

export function startJudge(library, judgeModule) {
    let worker, timer, rows = [], worst = [], doing = '';
    let asked; /* what is judged: options and code */

    function check([word, meaning]) {
        return element('label', {}, element('input', { type: 'checkbox', value: word }), meaning);
    }

    const boxes = () => [...$('judge-form').querySelectorAll('input[type=checkbox]')];

    function entry() {
        const words = boxes().filter(box => box.checked).map(box => box.value);
        return [...words, $('judge-words').value.trim()].filter(Boolean).join(' ');
    }

    function options() {
        return { entry: entry(), margin: $('judge-margin').value,
                 count: Number($('judge-count').value) };
    }

    const say = words => { $('judge-status').textContent = words; };

    /* Rows as they come. */

    function cell(value, wrong) {
        return element('td', { class: wrong ? 'n wrong' : 'n' }, value);
    }

    function addRow(row) {
        const share = row.valid > 0 ? 100 * row.wrong / row.valid : 0, { faults, t_ulps } = row;
        const counted = name => cell(faults[name] ? grouped(faults[name]) : '·', faults[name] > 0);
        $('judge-rows').hidden = false;
        $('judge-rows').tBodies[0].append(element('tr', {},
            element('td', {}, row.shape), element('td', {}, row.regime),
            cell(row.wrong ? share.toFixed(share < 1 ? 2 : 1) : '0', row.wrong > 0),
            counted('false hit'), counted('false miss'), counted('wrong part'),
            cell(t_ulps.hits ? short(t_ulps.median) : ''),
            cell(t_ulps.hits ? short(t_ulps.most) : ''),
            cell(row.margins?.most ? short(row.margins.most) : '·')));
    }

    function sayRows(of) {
        const wrong = rows.filter(row => row.wrong > 0).length;
        say(`${rows.length} of ${of} rows; wrong decisions in ${wrong} of them`);
    }

    /* The smallest counterexamples. */

    function worstOf(one, margin) {
        const told = [one.shape, one.regime, one.event && one.event !== 'clear' ? one.event : '',
                      one.ulps ? `${short(one.ulps)} ulps` : '',
                      one.margin ? `wrong by ${short(one.margin)} ${UNITS[margin]}`
                                 : ''].filter(Boolean);
        return element('div', { class: 'worst' },
            element('h3', {}, `${one.kind} (${told.join(', ')})`),
            element('pre', { tabindex: 0 }, `${numbersOf(one.case)}\nanswer  ${decimal(one.answer)}` +
                                            `\nright   ${decimal(one.right)}\n\n${one.case}`));
    }

    const written = number => Object.is(number, -0) ? '-0' : String(number);

    /* A number of a line as JavaScript writes it. */
    function decimalOf(word) {
        const parts = /^(-?)0x([01])(?:\.([0-9a-f]+))?p([+-]\d+)$/.exec(word);
        if (!parts)
            return word;
        const [, sign, whole, digits = '', power] = parts, scale = Number(power);
        const mantissa = Number(whole) + (digits ? parseInt(digits, 16) / 16 ** digits.length : 0);
        const half = Math.trunc(scale / 2); /* each power of two is a double */
        return written((sign ? -1 : 1) * mantissa * 2 ** half * 2 ** (scale - half));
    }

    const decimal = line => line.split(' ').map(decimalOf).join(' ');

    function numbersOf(line) {
        const { shape, ray, object } = library.readCase(line);
        const list = value => Array.isArray(value) ? `[${value.map(written).join(', ')}]`
                                                  : written(value);
        const members = of => Object.entries(of).map(([name, is]) => `${name}: ${list(is)}`);
        return `ray     {${members(ray).join(', ')}}\n${shape.padEnd(7)} {${members(object).join(', ')}}`;
    }

    /* Throws unless it is as showLink makes it. */
    function checkLink({ code, entry: words, margin, count, worst: told }) {
        const counts = [...$('judge-count').options].map(option => option.value);
        if (typeof code !== 'string' || typeof words !== 'string' ||
            !Object.hasOwn(UNITS, margin) || !counts.includes(String(count)))
            throw new TypeError('it is no verdict’s');
        told.forEach(one => worstOf(one, margin));
    }

    function showWorst(heading) {
        $('judge-worst').replaceChildren();
        if (worst.length > 0)
            $('judge-worst').append(element('h2', {}, heading),
                                     ...worst.map(one => worstOf(one, asked.margin)));
    }

    /* Running. */

    function running(is) {
        $('judge-run').disabled = is;
        $('judge-stop').disabled = !is;
    }

    function end(words) {
        clearTimeout(timer);
        worker?.terminate();
        worker = undefined;
        running(false);
        say(words);
    }

    function wait() {
        clearTimeout(timer);
        timer = setTimeout(() => end(`stopped: no answer in ${PATIENCE / 1000} seconds, ` +
                                     `about ${doing || 'the first question'}`), PATIENCE);
    }

    /* JSON has no infinity. */
    async function showLink() {
        const said = JSON.stringify({ ...asked, worst }, (_, is) => is === Infinity ? `${is}` : is);
        $('judge-link').href = hashOf('judge', { v: await packed(said) });
        $('judge-link').hidden = false;
    }

    async function done(found) {
        worst = found.worst;
        showWorst('The smallest counterexamples, one of each kind');
        await showLink();
        const wrong = found.rows.reduce((sum, row) => sum + row.wrong, 0);
        const asked = found.rows.reduce((sum, row) => sum + row.valid, 0);
        const thrown = found.thrown.length > 0 ? ` It threw: ${found.thrown[0]}.` : '';
        end(`Done: ${grouped(wrong)} of ${grouped(asked)} decisions wrong.${thrown}`);
        $('judge').dataset.done = 'true';
    }

    function heard(message) {
        wait();
        if (message.kind === 'alive') {
            doing = message.what;
        } else if (message.kind === 'row') {
            rows.push(message.row);
            addRow(message.row);
            sayRows(message.of);
        } else if (message.kind === 'done') {
            done(message.found);
        } else if (message.kind === 'error') {
            end(message.message);
        }
    }

    function run() {
        rows = worst = [];
        rows = [];
        doing = '';
        asked = { ...options(), code: $('judge-code').value };
        $('judge-rows').tBodies[0].replaceChildren();
        $('judge-margin-head').textContent = `margin, ${UNITS[asked.margin]}`;
        $('judge-link').hidden = true;
        delete $('judge').dataset.done;
        showWorst();
        end('Asking ...');
        running(true);
        worker = startWorker([{ judge: judgeModule }], heard);
        const { code, ...how } = asked;
        worker.postMessage({ kind: 'judge', code, options: how });
        wait();
    }

    function showExample() {
        const { code, original, entry: words = '' } = EXAMPLES[$('judge-example').value];
        $('judge-code').value = code;
        $('judge-original').hidden = !original;
        $('judge-original').querySelector('pre').textContent = original ? $(original).textContent
                                                                        : '';
        setEntry(words);
    }

    function setEntry(words) {
        const list = words.split(/[\s,]+/).filter(Boolean), all = boxes();
        all.forEach(box => { box.checked = list.includes(box.value); });
        $('judge-words').value = list.filter(word => !all.some(box => box.value === word)).join(' ');
    }

    $('judge-entries').append(...ENTRIES.map(check));
    $('judge-allowed').append(...ALLOWED.map(check));
    $('judge-margin').append(...Object.entries(UNITS).map(([value, words]) =>
        element('option', { value }, words)));
    $('judge-example').append(...Object.keys(EXAMPLES).map(name => element('option', {}, name)));
    $('judge-example').addEventListener('change', showExample);
    $('judge-form').addEventListener('submit', event => {
        event.preventDefault();
        run();
    });
    $('judge-stop').addEventListener('click', () => end(`Stopped after ${rows.length} rows.`));
    showExample();

    return {
        code: () => $('judge-code').value,
        hash: () => '#judge',
        async open({ v }) {
            if (!v)
                return;
            try {
                const said = JSON.parse(await unpacked(v),
                                        (_, is) => is === 'Infinity' ? Infinity : is);
                checkLink(said);
                end('From a link. Read the code, then judge it anew.');
                $('judge-code').value = said.code;
                setEntry(said.entry);
                $('judge-margin').value = said.margin;
                $('judge-count').value = String(said.count);
                asked = said;
                worst = said.worst;
                showWorst('The counterexamples of this link');
            } catch (error) {
                say(`This link can’t be read: ${error}`);
            }
        },
    };
}
