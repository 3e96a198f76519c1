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
