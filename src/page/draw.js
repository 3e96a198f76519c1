// SPDX-License-Identifier: MIT
/* "Draw": a scene's text beside its picture. */
import { $, contextOf, element, grouped, hashOf, moduleOf, packed, startWorker, unpacked } from './base.js';

const PAUSE = 250; /* ms after the last key */

export function startDraw(library) {
    let worker, id = 0, timer, notes = [], pictures = [], wrong = 0, told = 0;
    let address = '#draw';

    const text = () => $('draw-text').value;
    const say = words => { $('draw-status').textContent = words; };
    const besides = () => $('draw-beside').value;

    /* Errors, at their line and column. */

    /* Where line and column are; columns count bytes of UTF-8, none of a byte order mark. */
    function offsetOf({ line, column }) {
        const lines = text().split('\n'), row = lines[line - 1] ?? '';
        let at = lines.slice(0, line - 1).reduce((sum, before) => sum + before.length + 1, 0);
        const encoder = new TextEncoder();
        let bytes = line === 1 && row.startsWith('\ufeff') ? -3 : 0;
        for (const letter of row) {
            if (bytes >= column - 1)
                break;
            bytes += encoder.encode(letter).length;
            at += letter.length;
        }
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

    /* How many there are; the last line may count more. */
    function errorsOf(list) {
        const errors = list.filter(note => note.kind === 'error').map(note => note.message);
        return errors.reduce((sum, words) => sum + Number(/^(\d+) more/.exec(words)?.[1] ?? 1), 0);
    }

    /* Pictures. */

    /* Can the browser have such a canvas? One that is too large holds nothing. */
    function canHold(width, height) {
        const context = contextOf(element('canvas', { width, height }));
        context.fillRect(0, 0, 1, 1);
        return context.getImageData(0, 0, 1, 1).data[3] > 0;
    }

    async function stop(words) {
        const drawing = worker;
        worker = undefined;
        id++;
        say(words);
        (await drawing).terminate();
    }

    function begin({ width, height, notes: list }) {
        showNotes(list);
        const errors = errorsOf(list);
        if (!width)
            return say(`${errors} ${errors === 1 ? 'error' : 'errors'}: nothing is drawn.`);
        if (!canHold(width, height))
            return stop(`${grouped(width)} by ${grouped(height)} pixels are too many here.`);
        for (const canvas of [$('draw-canvas'), $('draw-canvas-other')])
            Object.assign(canvas, { width, height });
        pictures = [[$('draw-tier').value, $('draw-canvas')]];
        if (besides())
            pictures.push([besides(), $('draw-canvas-other')]);
        say('Drawing ...');
    }

    function putTile({ tier, tile, pixels: data, wrong: found }) {
        const image = new ImageData(data, tile.width, tile.height);
        for (const [of, canvas] of pictures)
            if (of === tier)
                contextOf(canvas).putImageData(image, tile.x, tile.y);
        if (found !== undefined && tier === $('draw-tier').value) {
            wrong += found;
            told += tile.width * tile.height;
        }
    }

    function differences() {
        const [one, two] = pictures.map(([, canvas]) =>
            new Uint32Array(contextOf(canvas).getImageData(0, 0, canvas.width,
                                                                 canvas.height).data.buffer));
        return one.reduce((sum, pixel, i) => sum + (pixel !== two[i]), 0);
    }

    function drawn() {
        const { width, height } = $('draw-canvas'), size = grouped(width * height);
        const words = [`${size} pixels.`];
        if (pictures.length > 1)
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
            address = hashOf('draw', { v: await packed(text()) });
            if (!$('draw').hidden)
                history.replaceState(null, '', address);
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
        hash: () => address,
        async open({ v }) {
            try {
                if (v) {
                    $('draw-text').value = await unpacked(v);
                    address = hashOf('draw', { v });
                }
            } catch (error) {
                return say(`This link can’t be read: ${error}`);
            }
            await draw(false);
        },
    };
}
