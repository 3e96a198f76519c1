// SPDX-License-Identifier: MIT
/* The page used as a person would, in a browser without a window:
 *
 *     test_page.mjs CHROMIUM PLAYGROUND SUREHIT SCENES FOLDER
 *
 * at 1280 and at 400 pixels, light and dark, by keyboard alone. Screenshots go to FOLDER. */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import test, { after, before } from 'node:test';
import { deflateRawSync } from 'node:zlib';

import { openBrowser, openPage } from './browser.mjs';

const [chromium, playground, surehit, scenes, folder] = process.argv.slice(2);
const url = pathToFileURL(playground).href;
const contrast = readFileSync(new URL('contrast.js', import.meta.url), 'utf8');
let browser;

before(async () => {
    mkdirSync(folder, { recursive: true });
    browser = await openBrowser(chromium);
});
after(() => browser.close());

const WAYS = [1280, 400].flatMap(width => [false, true].map(dark => ({ width, dark })));
const nameOf = ({ width, dark }) => `${width} ${dark ? 'dark' : 'light'}`;

/* Opens the page, and holds in the end what holds for each visit. */
async function visit(how, hash, use) {
    const page = await openPage(browser, how);
    try {
        page.begun = await browser.computed();
        await page.go(url + hash);
        await page.until('document.querySelector("[aria-selected=true]")');
        await use(page);
        const { count, low } = await page.evaluate(contrast);
        assert.deepEqual(low, [], 'contrast');
        assert(count >= 15, `${count} words whose contrast was found`);
        const wide = await page.evaluate('document.documentElement.scrollWidth - innerWidth');
        assert(wide <= 0, `${wide} pixels wider than the window`);
        assert.deepEqual(page.complaints, []);
        assert(page.asked.every(to => to.startsWith(url) || to.startsWith('blob:')),
               `asked for ${page.asked}`);
        const unnamed = await page.evaluate(`[...document.querySelectorAll(
            'button, select, input, textarea, canvas, a')].filter(e => e.checkVisibility() &&
            !(e.labels?.length || e.ariaLabel || e.textContent.trim())).map(e => e.outerHTML)`);
        assert.deepEqual(unnamed, [], 'what has no name');
        writeFileSync(join(folder, `${hash.slice(1).split('&')[0]}-${nameOf(how)}.png`.replace(' ', '-')),
                      await page.picture());
    } finally {
        await page.close();
    }
}

const focused = 'document.activeElement.id || document.activeElement.textContent';

/* Presses Tab until that has the focus. */
async function tabTo(page, expression) {
    for (let i = 0; i < 60; i++) {
        if (await page.evaluate(`document.activeElement.matches('${expression}')`))
            return;
        await page.press('Tab');
    }
    assert.fail(`Tab does not lead to ${expression}, but to ${await page.evaluate(focused)}`);
}

/* Each part is used in each way, one after the other. */
const inEachWay = (name, use) => {
    for (const how of WAYS)
        test(`${name}, ${nameOf(how)}`, { timeout: 600000 }, () => use(how));
};

const wrongOf = (page, tier) => page.evaluate(
    `(document.querySelector('[data-tile=${tier}] .wrong')?.textContent ?? '0')
     .replace(/[^0-9]/g, '')`).then(Number);
const drawn = 'document.getElementById("see").dataset.drawn';
const captionOf = name => `document.querySelector('[data-tile=${name}] figcaption').textContent`;

inEachWay('see it', how => visit(how, '#see', async page => {
    await page.until(drawn);
    const took = await browser.computed() - page.begun;
    console.log(`first picture after ${Math.round(await page.evaluate(drawn))} ms, ` +
                `${took.toFixed(2)} s of processor time`);
    assert(took > 0 && took < 10, `${took} s of processor time until the first picture`);
    await page.until(`${captionOf('yours')}.includes('wrong')`);
    assert(await wrongOf(page, 'textbook') > 50);
    assert(await wrongOf(page, 'float32') > 500);
    assert.equal(await wrongOf(page, 'yours'), await wrongOf(page, 'textbook'));

    /* The zoom by keyboard, down to single ulps. */
    await tabTo(page, '#see-zoom');
    await page.press('End');
    await page.until('document.getElementById("see-zoom-is").textContent.includes("1 ulp")');
    for (const tier of ['certain', 'exact'])
        assert.equal(await wrongOf(page, tier), 0);

    /* A cone's apex by its button. */
    await page.evaluate('document.getElementById("tab-see").focus()');
    await tabTo(page, '.presets button:nth-child(3)');
    await page.press('Enter');
    await page.until(`${captionOf('yours')}.includes('no function cone')`);
    assert.equal(await page.evaluate('document.getElementById("see-place").value'), 'apex');
    assert(await wrongOf(page, 'textbook') > 100);
    assert.equal(await wrongOf(page, 'certain'), 0);

    /* Another ray of a picture. */
    await tabTo(page, '[data-tile=textbook] canvas');
    const cell = 'document.getElementById("see-cell").textContent';
    const before = await page.evaluate(cell);
    await page.press('ArrowLeft');
    await page.press('ArrowUp');
    const after = await page.evaluate(cell);
    assert.match(after, /^ray -1 right, 1 up/);
    assert.notEqual(after, before);
    assert.match(after, /exact +(hit|miss)/);
    assert.match(await page.evaluate('location.hash'), /^#see&shape=cone&place=apex/);
}));

test('every shape and place has a picture in which certain is never wrong', { timeout: 600000 },
     () => visit({ width: 1280 }, '#see', async page => {
    await page.until(drawn);
    const places = await page.evaluate(`Object.fromEntries([...document.getElementById('see-shape')
        .options].map(o => [o.value, 0]))`);
    for (const shape of Object.keys(places)) {
        await page.evaluate(`{ const s = document.getElementById('see-shape'); s.value = '${shape}';
            s.dispatchEvent(new Event('input')); }`);
        await page.until(`location.hash.includes('shape=${shape}&')`);
        const list = await page.evaluate(
            `[...document.getElementById('see-place').options].map(o => o.value)`);
        for (const place of list) {
            await page.evaluate(`{ const s = document.getElementById('see-place');
                s.value = '${place}'; s.dispatchEvent(new Event('input')); }`);
            await page.until(`location.hash.includes('place=${place}&')`);
            assert.equal(await wrongOf(page, 'certain'), 0);
            const hits = await page.evaluate(`(() => { const c = document.querySelector(
                '[data-tile=exact] canvas'), d = c.getContext('2d').getImageData(0, 0, 64, 64).data;
                return new Set(Array.from({ length: 4096 }, (_, i) => d[4 * i])).size; })()`);
            assert(hits > 1, `${shape} ${place}: hits and misses`);
        }
    }
}));

const yours = captionOf('yours');

/* Shows what a function of one's own does. */
async function seeOwn(page, code) {
    await page.evaluate(`document.getElementById('judge-code').value = ${JSON.stringify(code)};
        ${yours.replace('.textContent', '.replaceChildren()')};
        document.getElementById('tab-see').click()`);
    await page.until(yours);
    return page.evaluate(yours);
}

test('one’s own function is seen as it is judged', { timeout: 600000 },
     () => visit({ width: 1280 }, '#see', async page => {
    await page.until(drawn);
    assert.match(await seeOwn(page, 'function sphere() { throw Object.create(null); }'),
                 /^yours4,096 wrong of .*It threw: what has no words$/);
    assert.match(await seeOwn(page, 'function sphere() { return "invalid"; }'), /^yours4,096 wrong/);
    assert.match(await seeOwn(page, 'function sphere() { return true; }'), /; a hit without t$/);
    assert.equal(await seeOwn(page, 'throw Object.create(null);'), 'yourswhat has no words');
    const mutating = `function sphere(ray, ball) {
        const a = ray.direction.reduce((sum, d) => sum + d * d, 0);
        const b = ray.direction.reduce((sum, d, i) => sum + d * ray.origin[i], 0);
        const c = ray.origin.reduce((sum, o) => sum + o * o, 0) - (ball.radius *= ball.radius);
        ball.radius /= 2;
        return b * b < a * c ? null : (-b - Math.sqrt(b * b - a * c)) / a;
    }`;
    await seeOwn(page, mutating);
    assert(await wrongOf(page, 'yours') < 1000, 'each ray has an object of its own');

    /* Its canvas says so where there is no picture. */
    await seeOwn(page, 'const ball = 1;');
    const label = 'document.querySelector("[data-tile=yours] canvas").ariaLabel';
    assert.equal(await page.evaluate(label), 'yours: there is no function sphere');
}));

test('many changes do not stop one’s own function', { timeout: 600000 },
     () => visit({ width: 1280 }, '#see', async page => {
    await page.until(drawn);
    await seeOwn(page, `function sphere() {
        for (const end = performance.now() + 0.06; performance.now() < end;);
        return null;
    }`);
    await page.evaluate(`(async () => { const slider = document.getElementById('see-around');
        for (let i = 0; i < 24; i++) {
            slider.value = i;
            slider.dispatchEvent(new Event('input'));
            await new Promise(requestAnimationFrame);
        } ${yours.replace('.textContent', '.replaceChildren()')}; })()`);
    await page.until(yours);
    assert.match(await page.evaluate(yours), /wrong of 4,096/);
}));

test('arrow keys end at a picture’s edge, and with Alt are the browser’s',
     () => visit({ width: 1280 }, '#see', async page => {
    await page.until(drawn);
    await tabTo(page, '[data-tile=exact] canvas');
    for (let i = 0; i < 40; i++)
        await page.press('ArrowLeft');
    const cell = 'document.getElementById("see-cell").textContent';
    assert.match(await page.evaluate(cell), /^ray -32 right, 0 up/);
    const taken = id => page.evaluate(`!document.querySelector('${id}').dispatchEvent(
        new KeyboardEvent('keydown', { key: 'ArrowRight', altKey: true, cancelable: true }))`);
    assert(!await taken('[data-tile=exact] canvas') && !await taken('#tab-see'));
    assert.match(await page.evaluate(cell), /^ray -32 right, 0 up/);
    assert(await page.evaluate('!document.getElementById("see").hidden'));
}));

const status = 'document.getElementById("judge-status").textContent';

/* Writes into a text area in the place of what is there. */
async function write(page, id, text) {
    await tabTo(page, `#${id}`);
    await page.evaluate(`document.getElementById('${id}').select()`);
    await page.type(text);
}

inEachWay('judge yours', how => visit(how, '#judge', async page => {
    await tabTo(page, '#judge-count');
    await page.press('ArrowUp');
    await tabTo(page, '#judge-run');
    await page.press('Enter');
    await page.until('document.getElementById("judge-rows").rows.length > 2');
    await page.until('document.getElementById("judge").dataset.done');
    assert.match(await page.evaluate(status), /^Done: [\d,]+ of [\d,]+ decisions wrong/);
    const rows = await page.evaluate('document.getElementById("judge-rows").tBodies[0].rows.length');
    assert(rows > 30, `${rows} rows`);
    const worst = 'document.querySelectorAll(".worst").length';
    assert(await page.evaluate(worst) >= 3);

    /* The link holds code and counterexamples. */
    const link = await page.evaluate('document.getElementById("judge-link").href');
    await visit(how, link.slice(link.indexOf('#')), async other => {
        await other.until(`${worst} >= 3`);
        assert.equal(await other.evaluate('document.getElementById("judge-code").value'),
                     await page.evaluate('document.getElementById("judge-code").value'));
        assert.deepEqual(await other.evaluate('document.getElementById("judge-worst").innerText')
                             .then(text => text.split('\n').slice(1)),
                         await page.evaluate('document.getElementById("judge-worst").innerText')
                             .then(text => text.split('\n').slice(1)));
    });
}));

const run = async page => {
    await tabTo(page, '#judge-run');
    await page.press('Enter');
};

test('who hangs is stopped, who throws is told', { timeout: 600000 },
     () => visit({ width: 1280 }, '#judge', async page => {
    await write(page, 'judge-code', 'function sphere() { for (;;); }');
    await run(page);
    await page.until(`${status}.startsWith('stopped: no answer')`);
    await write(page, 'judge-code', 'function sphere() { while (true); }');
    await run(page);
    await tabTo(page, '#judge-stop');
    await page.press('Enter');
    await page.until(`${status}.startsWith('Stopped')`);
    await write(page, 'judge-code', 'function sphere(ray) { return ray.nothing.x; }');
    await run(page);
    await page.until('document.getElementById("judge").dataset.done');
    assert.match(await page.evaluate(status), /It threw: TypeError/);
    await write(page, 'judge-code', 'function sphere( {');
    await run(page);
    await page.until(`${status}.includes('SyntaxError')`);
    await write(page, 'judge-code', 'const ball = 1;');
    await run(page);
    await page.until(`${status}.includes('no function is named')`);
    await page.evaluate('document.getElementById("tab-see").click()');
    await page.until(`${captionOf('yours')}.includes('no function sphere')`);
}));

test('examples are judged under their entries', { timeout: 600000 },
     () => visit({ width: 1280 }, '#judge', async page => {
    for (const [at, words] of [[1, 'float'], [2, 'unit t_min=0 inside=0']]) {
        await page.evaluate(`{ const s = document.getElementById('judge-example');
            s.selectedIndex = ${at}; s.dispatchEvent(new Event('change')); }`);
        assert.equal(await page.evaluate(`[...document.querySelectorAll('#judge-form :checked')]
            .filter(e => e.type === 'checkbox').map(e => e.value).join(' ')`), words);
        assert(await page.evaluate('!document.getElementById("judge-original").hidden'));
        await page.evaluate('document.getElementById("judge-count").selectedIndex = 0');
        await run(page);
        await page.until('document.getElementById("judge").dataset.done');
        const typical = await page.evaluate(`[...document.getElementById('judge-rows').tBodies[0]
            .rows].find(row => row.cells[1].textContent === 'typical').cells[2].textContent`);
        assert(Number(typical) < 5, `${typical} % wrong where all is usual`);
    }
}));

const linkTo = said => `#judge&v=${deflateRawSync(JSON.stringify(said)).toString('base64url')}`;
const worstText = '[...document.querySelectorAll(".worst")].map(one => one.innerText).join("\\n")';

test('a link holds what was judged, and what is none changes nothing', { timeout: 600000 },
     () => visit({ width: 1280 }, '#judge', async page => {
    const code = 'function sphere() { return true; }';
    await page.evaluate(`document.getElementById('judge-code').value = '${code}';
        document.getElementById('judge-count').value = '100';
        document.getElementById('judge-run').click();
        document.getElementById('judge-code').value = 'const later = 1;';
        document.getElementById('judge-margin').value = 'ulps'`);
    await page.until('document.getElementById("judge").dataset.done');
    const told = await page.evaluate(worstText);
    assert.match(told, /wrong by .* in sizes of the object/);
    assert.match(told, /Infinity ulps/);
    const link = await page.evaluate('document.getElementById("judge-link").hash');
    await visit({ width: 1280 }, link, async other => {
        await other.until(`${status}.startsWith('From a link')`);
        assert.equal(await other.evaluate(worstText), told);
        assert.equal(await other.evaluate('document.getElementById("judge-code").value'), code);
        assert.equal(await other.evaluate('document.getElementById("judge-margin").value'), 'size');
    });
    const good = { code, entry: '', margin: 'size', count: 100, worst: [] };
    for (const bad of [null, {}, { ...good, code: 1 }, { ...good, margin: 'x' },
                       { ...good, count: 7 }, { ...good, worst: null },
                       { ...good, worst: [{ case: 'sphere 1' }] },
                       { ...good, worst: [{ case: `sphere ${'0x1p+0 '.repeat(11)}0x1p+0` }] }])
        await visit({ width: 1280 }, linkTo(bad), async other => {
            await other.until(`${status}.startsWith('This link can’t be read')`);
            assert.match(await other.evaluate('document.getElementById("judge-code").value'),
                         /^\/\/ The sphere/);
            assert.equal(await other.evaluate('document.getElementById("judge-margin").value'),
                         'size');
        });
    const worst = [{ kind: 'false hit', shape: 'sphere', regime: 'tiny', answer: 'hit -0x0p+0',
                     right: 'miss',
                     case: `sphere 0x0p+0 -0x0p+0 0x1p+0 ${'0x1p+0 '.repeat(8)}0x1p+0` }];
    await visit({ width: 1280 }, linkTo({ ...good, worst }), async other => {
        await other.until(`${status}.startsWith('From a link')`);
        assert.match(await other.evaluate(worstText), /origin: \[0, -0, 1\][^]*answer +hit -0\n/);
    });
}));

/* The picture as the page has it, three bytes a pixel. */
const pixelsOf = id => `(() => { const c = document.getElementById('${id}');
    const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
    let s = ''; for (let i = 0; i < d.length; i++) if (i % 4 < 3) s += String.fromCharCode(d[i]);
    return btoa(s); })()`;
const drawnNow = 'document.getElementById("draw").dataset.drawn';

function nativePicture(scene, ...words) {
    const to = join(folder, 'native.ppm');
    execFileSync(surehit, ['render', scene, '-o', to, '--quiet', ...words]);
    const file = readFileSync(to), size = /^P6\s+(\d+)\s+(\d+)\s+255\s/.exec(file.toString('latin1'));
    return file.subarray(size[0].length);
}

inEachWay('draw', how => visit(how, '#draw', async page => {
    await page.until(drawnNow);
    const native = nativePicture(join(scenes, 'default.rt'), '--size', '640x360');
    assert(Buffer.from(await page.evaluate(pixelsOf('draw-canvas')), 'base64').equals(native),
           'the picture is not the native one');

    await write(page, 'draw-text', 'C 0,0,5 0,0,-1 60\nL 3,3,3 0.7 255,255,255\n' +
                                   'A 0.2 255,255,255\nsp 0,0,0 x 255,0,0\n');
    await page.until('document.querySelector("#draw-errors button")');
    const error = await page.evaluate('document.querySelector("#draw-errors button").textContent');
    assert.match(error, /^4:10: /);
    assert.equal(await page.evaluate('document.querySelector("#draw-marks mark").textContent'), 'x');
    await tabTo(page, '#draw-errors button');
    await page.press('Enter');
    assert.equal(await page.evaluate('getSelection().toString() || document.activeElement.value' +
        '.slice(document.activeElement.selectionStart, document.activeElement.selectionEnd)'), 'x');
    await page.type('2');
    await page.until(`!document.querySelector('#draw-errors button') && ${drawnNow}`);

    await page.evaluate('document.getElementById("tab-draw").focus()');
    await tabTo(page, '#draw-beside');
    await page.press('ArrowDown');
    await page.until(`!document.getElementById('draw-other').hidden && ${drawnNow}`);
    await tabTo(page, '#draw-check');
    await page.press('Enter');
    await page.until('document.getElementById("draw-status").textContent.includes("all right")');
}));

test('pictures are the native ones', { timeout: 600000 },
     () => visit({ width: 1280 }, '#draw', async page => {
    await page.until(drawnNow); // no earlier picture comes between
    for (const name of ['boxes', 'mirrors', 'left', 'inside', 'photons_mirror']) {
        const scene = join(scenes, `${name}.rt`), text = readFileSync(scene, 'utf8');
        await page.evaluate(`{ const t = document.getElementById('draw-text');
            t.value = ${JSON.stringify(text)};
            document.getElementById('draw-size').value = '320x180';
            delete document.getElementById('draw').dataset.drawn;
            t.dispatchEvent(new Event('input')); }`);
        await page.until(drawnNow);
        const native = nativePicture(scene, '--size', '320x180');
        assert(Buffer.from(await page.evaluate(pixelsOf('draw-canvas')), 'base64').equals(native),
               `${name} is not the native picture`);
    }
}));

const BEGIN = 'A 0.2 255,255,255\nC 0,0,5 0,0,-1 60\n', LIGHT = 'L 3,3,3 0.7\n';
const drawStatus = 'document.getElementById("draw-status").textContent';
const writeScene = (page, text) => page.evaluate(`{ const t = document.getElementById('draw-text');
    t.value = ${JSON.stringify(text)};
    delete document.getElementById('draw').dataset.drawn;
    document.getElementById('draw-status').textContent = '';
    t.dispatchEvent(new Event('input')); }`);

test('faults of a scene are counted, and marked where they are', { timeout: 600000 },
     () => visit({ width: 1280 }, '#draw', async page => {
    await page.until(drawnNow);
    const marks = '[...document.querySelectorAll("mark")].map(mark => mark.textContent).join()';
    for (const [text, count, marked] of [
        [`${BEGIN}${LIGHT}sp 😀,0,0 x 255,0,0\n`, '2 errors', '😀,x'],
        [`\ufeffsp 0,0,0 x 255,0,0\n${BEGIN}${LIGHT}`, '1 error', 'x'],
        [`${BEGIN}sp 0,0,0 x 255,0,0`, '1 error', 'x, '], // and no light is a warning
    ]) {
        await writeScene(page, text);
        await page.until(drawStatus);
        assert.equal(await page.evaluate(drawStatus), `${count}: nothing is drawn.`);
        assert.equal(await page.evaluate(marks), marked);
    }
    await writeScene(page, BEGIN + LIGHT + 'sp\n'.repeat(25));
    await page.until(drawStatus);
    assert.equal(await page.evaluate(drawStatus), '25 errors: nothing is drawn.');
    const last = '[...document.querySelectorAll("#draw-errors button")].at(-1)';
    assert.equal(await page.evaluate(`${last}.textContent`), '5 more errors');
    const words = Array.from({ length: 22 }, (_, i) => `W${i} 1\n`).join('');
    await writeScene(page, `#! dialect 42\n${BEGIN}${LIGHT}${words}sp 0,0,0 1 9,9,9\n`);
    await page.until(drawnNow);
    assert.equal(await page.evaluate(`${last}.textContent`),
                 'warning: 2 more unknown kinds are left out');
}));

test('the address holds the scene, beside a tier may stand itself', { timeout: 600000 },
     () => visit({ width: 1280 }, '#draw', async page => {
    await page.until(drawnNow);
    await writeScene(page, `${BEGIN}${LIGHT}sp 0,0,0 2 255,0,0\n`);
    await page.until('location.hash.startsWith("#draw&v=")');
    const address = await page.evaluate('location.hash');
    await page.evaluate('document.getElementById("tab-see").click()');
    await page.evaluate('document.getElementById("tab-draw").click()');
    assert.equal(await page.evaluate('location.hash'), address);

    /* Nor does it say another part than is shown. */
    await page.until(drawnNow);
    await writeScene(page, `${BEGIN}${LIGHT}`);
    await page.evaluate('document.getElementById("tab-see").click()');
    await page.until(drawnNow); // though nobody sees it
    assert.match(await page.evaluate(
        'new Promise(done => setTimeout(() => done(location.hash), 100))'), /^#see&/);
    await page.evaluate('document.getElementById("tab-draw").click()');
    assert.match(await page.evaluate('location.hash'), /^#draw&v=/);
    assert.notEqual(await page.evaluate('location.hash'), address);

    await page.until(drawnNow); // what the tab's choice draws is not taken for the next picture
    await writeScene(page, `${BEGIN}${LIGHT}sp 0,0,0 2 255,0,0\n`);
    await page.until(drawnNow);
    await page.evaluate(`{ const menu = document.getElementById('draw-beside');
        menu.value = 'certain';
        menu.dispatchEvent(new Event('change')); }`);
    await page.until(`${drawnNow} && ${drawStatus} === '230,400 pixels. 0 differ.'`);
    assert.equal(await page.evaluate(pixelsOf('draw-canvas')),
                 await page.evaluate(pixelsOf('draw-canvas-other')));

    /* What no canvas can hold is told, and what follows is drawn. */
    await page.evaluate('document.getElementById("draw-size").value = ""');
    await writeScene(page, `${BEGIN}${LIGHT}R 65535 65535\n`);
    await page.until(`${drawStatus} === '65,535 by 65,535 pixels are too many here.'`);
    await writeScene(page, `${BEGIN}${LIGHT}R 64 36\n`);
    await page.until(`${drawStatus} === '2,304 pixels. 0 differ.'`);
}));

test('a link that is cut off is told', () => visit({ width: 1280 }, '#see', async page => {
    await page.until(drawn);
    const link = linkTo({ code: 'function sphere() { return null; }' });
    for (const [part, said] of [['judge', status], ['draw', drawStatus]]) {
        await page.evaluate(`location.hash = '${link.slice(0, -9).replace('judge', part)}'`);
        await page.until(`${said} === 'This link can’t be read: TypeError: it is cut off, or spoiled'`);
    }
}));

test('parts are chosen by arrow keys', () => visit({ width: 400 }, '#see', async page => {
    await page.until(drawn);
    await tabTo(page, '#tab-see');
    await page.press('ArrowRight');
    assert.equal(await page.evaluate(focused), 'tab-judge');
    assert(await page.evaluate('!document.getElementById("judge").hidden'));
    await page.press('ArrowLeft');
    await page.press('ArrowLeft');
    assert(await page.evaluate('!document.getElementById("draw").hidden'));
    await page.until(drawnNow);
}));
