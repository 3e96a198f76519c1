// SPDX-License-Identifier: MIT
/* "Draw": a scene's text beside its picture. */
import { $, contextOf, element, grouped, hashOf, moduleOf, packed, startWorker, unpacked } from './base.js';

const PAUSE = 250; /* ms after the last key */

export function startDraw(library) {
    let worker, id = 0, timer, notes = [], pixels = new Map(), wrong = 0, told = 0;

    const text = () => $('draw-text').value;
    const say = words => { $('draw-status').textContent = words; };
    const besides = () => $('draw-beside').value;

    /* Errors, at their line and column. */

    /* Where line and column are; columns count bytes of UTF-8. */
    function offsetOf({ line, column }) {
        const lines = text().split('\n'), row = lines[line - 1] ?? '';
        let at = lines.slice(0, line - 1).reduce((sum, before) => sum + before.length + 1, 0);
        const encoder = new TextEncoder();
        for (let i = 0, bytes = 0; i < row.length && bytes < column - 1; at++)
            bytes += encoder.encode(row[i++]).length;
        return Math.min(at, text().length);
    }

    function wordAt(offset) {
        const word = /^[^\s,]+/.exec(text().slice(offset));
        return word ? word[0].length : 1;
    }

    function goTo(note) {
        const at = offsetOf(note);
        $('draw-text').focus();
        $('draw-text').setSelectionRange(at, at + wordAt(at));
    }

    function showMarks() {
        const marks = [];
        let from = 0;
        for (const note of notes.filter(one => one.line > 0).sort((a, b) => offsetOf(a) - offsetOf(b))) {
            const at = offsetOf(note), end = at + wordAt(at);
            if (at < from)
                continue;
            marks.push(text().slice(from, at), element('mark', {}, text().slice(at, end).padEnd(1)));
            from = end;
        }
        $('draw-marks').replaceChildren(...marks, `${text().slice(from)}\n`);
        scroll();
    }

    function scroll() {
        $('draw-marks').scrollTop = $('draw-text').scrollTop;
        $('draw-marks').scrollLeft = $('draw-text').scrollLeft;
    }

    function showNotes(list) {
        notes = list;
        $('draw-errors').replaceChildren(...notes.map(note => element('li', {},
            element('button', { type: 'button', class: note.kind, onclick: () => goTo(note) },
                    `${note.line > 0 ? `${note.line}:${note.column}: ` : ''}` +
                    `${note.kind === 'error' ? '' : `${note.kind}: `}${note.message}`))));
        showMarks();
    }

    /* Pictures. */

    function begin({ width, height, notes: list }) {
        showNotes(list);
        if (!width)
            return say(`${list.length} ${list.length === 1 ? 'error' : 'errors'}: nothing is drawn.`);
        for (const canvas of [$('draw-canvas'), $('draw-canvas-other')])
            Object.assign(canvas, { width, height });
        pixels = new Map([[$('draw-tier').value, $('draw-canvas')]]);
        if (besides())
            pixels.set(besides(), $('draw-canvas-other'));
        say('Drawing ...');
    }

    function putTile({ tier, tile, pixels: data, wrong: found }) {
        const context = contextOf(pixels.get(tier));
        context.putImageData(new ImageData(data, tile.width, tile.height), tile.x, tile.y);
        if (found !== undefined && tier === $('draw-tier').value) {
            wrong += found;
            told += tile.width * tile.height;
        }
    }

    function differences() {
        const [one, two] = [...pixels.values()].map(canvas =>
            new Uint32Array(contextOf(canvas).getImageData(0, 0, canvas.width,
                                                                 canvas.height).data.buffer));
        return one.reduce((sum, pixel, i) => sum + (pixel !== two[i]), 0);
    }

    function drawn() {
        const { width, height } = $('draw-canvas'), size = grouped(width * height);
        const words = [`${size} pixels.`];
        if (pixels.size > 1)
            words.push(`${grouped(differences())} differ.`);
        if (told > 0)
            words.push(wrong === 0 ? `Certificate: ${grouped(told)} pixels, all right.`
                                   : `Certificate: ${grouped(wrong)} of ${grouped(told)} wrong.`);
        say(words.join(' '));
        $('draw').dataset.drawn = String(id);
    }

    function heard(message) {
        if (message.id !== id && message.kind !== 'error')
            return;
        const does = { scene: begin, tile: putTile, drawn,
                       error: () => say(message.message) };
        does[message.kind]?.(message);
    }

    function captions() {
        $('draw-other').hidden = !besides();
        $('draw-caption').textContent = $('draw-tier').value;
        $('draw-caption-other').textContent = besides();
    }

    async function draw(check) {
        captions();
        id++;
        wrong = told = 0;
        delete $('draw').dataset.drawn;
        worker ??= moduleOf('draw.wasm').then(drawer => startWorker([{ drawer }], heard));
        const tiers = [...new Set([$('draw-tier').value, besides()].filter(Boolean))];
        const size = ($('draw-size').value || '0x0').split('x').map(Number);
        const wanted = { kind: 'draw', id, text: text(), size, tiers, check };
        (await worker).postMessage(wanted);
    }

    function soon() {
        showMarks();
        clearTimeout(timer);
        timer = setTimeout(async () => {
            draw(false);
            history.replaceState(null, '', hashOf('draw', { v: await packed(text()) }));
        }, PAUSE);
    }

    const option = name => element('option', { value: name }, name || 'nothing');
    $('draw-tier').append(...library.tiers.map(option));
    $('draw-tier').value = 'certain';
    $('draw-beside').append(...['', ...library.tiers].map(option));
    $('draw-text').value = $('example-scene').textContent;
    $('draw-text').addEventListener('input', soon);
    $('draw-text').addEventListener('scroll', scroll);
    $('draw-check').addEventListener('click', () => draw(true));
    $('draw-controls').addEventListener('submit', event => event.preventDefault());
    for (const name of ['tier', 'beside', 'size'])
        $(`draw-${name}`).addEventListener('change', () => draw(false));

    return {
        hash: () => '#draw',
        async open({ v }) {
            try {
                if (v)
                    $('draw-text').value = await unpacked(v);
            } catch (error) {
                return say(`This link can’t be read: ${error}`);
            }
            await draw(false);
        },
    };
}
