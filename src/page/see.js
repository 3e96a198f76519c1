// SPDX-License-Identifier: MIT
/* "See it": a window of rays about a place, as each tier answers them. */
import { $, contextOf, element, grouped, hashOf, isCommand, short, startWorker } from './base.js';
import { OBJECTS, directionTo, eyeAt, ulpOf } from './places.js';

const SIDE = 64, COUNT = SIDE * SIDE; /* of the rays of a picture */
const WHOLE = 192, WIDTH = 3; /* of that of the whole object; in its unit */
const OWN_PATIENCE = 2000; /* ms for one's own function */
const COLOURS = ['miss', 'hit', 'false-hit', 'false-miss', 'wrong-part'];
const PRESETS = [
    ['A sphere’s limb, far away', { shape: 'sphere', place: 'limb', around: 40, far: 4, zoom: 24 }],
    ['… down to single ulps', { shape: 'sphere', place: 'limb', around: 40, far: 2, zoom: 47 }],
    ['A cone’s apex', { shape: 'cone', place: 'apex', around: 0, far: 1, zoom: 46 }],
    ['A cylinder’s rim', { shape: 'cylinder', place: 'rim', around: 200, far: 5, zoom: 38 }],
    ['A box’s corner', { shape: 'box', place: 'corner', around: 0, far: 3, zoom: 46 }],
];

export function startSee(library, judgeModule, ownCode) {
    const { shapes, tiers, statuses, parts, hits, hit, occluded } = library;
    const HIT = statuses.indexOf('hit');
    const state = { ...PRESETS[0][1] };
    const tiles = new Map();
    let window_, exact, cursor = COUNT / 2 + SIDE / 2, frame = 0, worker, timer;
    let asked = 0, busy = 0; /* questions of one's own function: the last, and that under way */

    /* The window. */

    function raysOf(eye, direction, step, side = SIDE) {
        const rays = new Float64Array(8 * side * side);
        for (let j = 0; j < side; j++)
            for (let i = 0; i < side; i++)
                rays.set([...eye, direction[0] + (i - side / 2) * step,
                          direction[1] - (j - side / 2) * step, direction[2], 0, Infinity],
                         8 * (j * side + i));
        return rays;
    }

    /* The finest step is an ulp of the larger coordinate; the coarsest shows all of the object. */
    function makeWindow() {
        const { shape, place } = state, eye = eyeAt(10 ** state.far), { object } = OBJECTS[shape];
        const isHit = d => occluded(shape, 'exact', { origin: eye, direction: d }, object) === 'hit';
        const angle = state.around * Math.PI / 180;
        const direction = directionTo(shape, place, angle, eye, isHit);
        const ulp = ulpOf(Math.max(Math.abs(direction[0]), Math.abs(direction[1])));
        const most = Math.round(Math.log2(4 / SIDE / ulp)), zoom = Math.min(state.zoom, most);
        const ulps = 2 ** (most - zoom), step = ulp * ulps;
        return { eye, direction, ulps, step, most, zoom, object, rays: raysOf(eye, direction, step) };
    }

    /* Colours. */

    function colourOf(i, said) {
        const isHit = said.status[i] === HIT;
        if (said.status[i] !== exact.status[i])
            return isHit ? 2 : 3;
        return isHit && said.part && said.part[i] !== exact.part[i] ? 4 : isHit ? 1 : 0;
    }

    const colour = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

    const palette = () => COLOURS.map(name => [1, 3, 5].map(at =>
        parseInt(colour(`--${name}`).slice(at, at + 2), 16)));

    /* Which part a right hit is on is told by its shade. */
    function paint(canvas, said) {
        const context = contextOf(canvas), image = context.createImageData(SIDE, SIDE);
        const colours = palette(), counts = COLOURS.map(() => 0);
        for (let i = 0; i < COUNT; i++) {
            const kind = colourOf(i, said), shade = kind === 1 ? 1 - 0.12 * (exact.part[i] % 3) : 1;
            counts[kind]++;
            image.data.set([...colours[kind].map(x => x * shade), 255], 4 * i);
        }
        context.putImageData(image, 0, 0);
        mark(context);
        return counts;
    }

    /* The ray of which the words tell: a frame about it. */
    function mark(context) {
        const x = cursor % SIDE, y = Math.floor(cursor / SIDE);
        context.strokeStyle = colour('--ink');
        context.lineWidth = 0.5;
        context.strokeRect(x - 0.75, y - 0.75, 2.5, 2.5);
    }

    /* The largest error of t of the hits that both have, in ulps. */
    function worstT(said) {
        let most = 0;
        for (let i = 0; i < COUNT; i++) {
            if (said.status[i] === HIT && exact.status[i] === HIT)
                most = Math.max(most, Math.abs(said.t[i] - exact.t[i]) / ulpOf(exact.t[i]));
        }
        return most;
    }

    function caption(name, said, counts) {
        const wrong = counts[2] + counts[3] + counts[4], off = worstT(said);
        const words = wrong > 0 ? element('span', { class: 'wrong' }, `${grouped(wrong)} wrong`)
                                : 'none wrong';
        tiles.get(name).caption.replaceChildren(
            element('b', {}, name), words, ` of ${grouped(COUNT)}; `,
            Number.isNaN(off) ? 'a hit without t'
                              : `t off by up to ${short(Math.round(off * 100) / 100)} ulp`,
            said.thrown === undefined ? '' : `. It threw: ${said.thrown}`);
        tiles.get(name).canvas.setAttribute('aria-label',
            `${name}: ${wrong} of ${COUNT} rays wrong. Arrow keys choose a ray.`);
    }

    function show(name, said) {
        tiles.get(name).said = said;
        caption(name, said, paint(tiles.get(name).canvas, said));
    }

    /* The object's middle, as the eye sees it, and where the window is from there; the window
     * itself where that is too far. */
    function wholeOf({ eye, direction, object }) {
        const middle = (object.point ?? [0, 0, 0]).map((x, i) => x - eye[i]);
        const scale = middle[2] / direction[2], step = WIDTH / WHOLE;
        const at = [0, 1].map(i => (scale * direction[i] - middle[i]) / step);
        return Math.hypot(...at) < WHOLE / 2 ? [middle, at, step] : [direction, [0, 0], step];
    }

    /* The whole object by its normals, and where the window is. */
    function showWhole() {
        const { canvas, caption } = tiles.get('where'), [middle, at, step] = wholeOf(window_);
        const said = hits(state.shape, 'certain', raysOf(window_.eye, middle, step, WHOLE),
                          Float64Array.from(Object.values(window_.object).flat()));
        const context = contextOf(canvas), image = context.createImageData(WHOLE, WHOLE);
        const [ground, surface] = palette();
        for (let i = 0; i < WHOLE * WHOLE; i++) {
            const [x, y, z] = said.normal.subarray(3 * i, 3 * i + 3);
            const light = 0.55 + 0.6 * Math.max(0, -0.4 * x + 0.6 * y + 0.7 * z);
            const shown = said.status[i] === HIT ? surface.map(c => c * light) : ground;
            image.data.set([...shown, 255], 4 * i);
        }
        context.putImageData(image, 0, 0);
        context.strokeStyle = colour('--bad');
        context.lineWidth = 3;
        context.beginPath();
        context.arc(WHOLE / 2 + at[0], WHOLE / 2 - at[1], 10, 0, 7);
        context.stroke();
        caption.replaceChildren(
            element('b', {}, 'the whole'), `from a distance of ${grouped(Math.round(10 ** state.far))}`);
    }

    /* The function of one's own, in a worker that is ended where it takes too long. */
    function endOwn(words) {
        worker?.terminate();
        worker = undefined;
        busy = 0;
        const tile = tiles.get('yours');
        tile.said = undefined;
        contextOf(tile.canvas).clearRect(0, 0, SIDE, SIDE);
        tile.caption.replaceChildren(element('b', {}, 'yours'), words);
        tile.canvas.setAttribute('aria-label', `yours: ${words}`);
    }

    function heardOwn(message) {
        if (message.id !== busy && message.kind !== 'error')
            return;
        const isLate = busy !== asked;
        clearTimeout(timer);
        busy = 0;
        if (isLate)
            askOwn();
        else if (message.kind === 'error')
            endOwn(message.message);
        else if (message.none)
            endOwn(`there is no function ${state.shape}`);
        else
            show('yours', message);
    }

    function stopOwn() {
        const isLate = busy !== asked;
        endOwn('no answer in time: stopped');
        if (isLate)
            askOwn();
    }

    /* One question at a time: a newer one waits for the answer, and is then the last. */
    function askOwn() {
        asked++;
        if (busy)
            return;
        busy = asked;
        worker ??= startWorker([{ judge: judgeModule }], heardOwn);
        worker.postMessage({ kind: 'own', id: busy, code: ownCode(), shape: state.shape,
                             rays: window_.rays, object: window_.object });
        timer = setTimeout(stopOwn, OWN_PATIENCE);
    }

    /* One ray, as all see it. */
    function tellCell() {
        const i = cursor, ray = window_.rays.subarray(8 * i, 8 * i + 8);
        const lines = [`ray ${cursor % SIDE - SIDE / 2} right, ${SIDE / 2 - Math.floor(cursor / SIDE)} ` +
                       `up: d = ${Array.from(ray.subarray(3, 6)).join(', ')}`];
        for (const tier of tiers) {
            const said = hit(state.shape, tier, ray, window_.object);
            const words = said.status === 'hit' ? `hit ${said.part} at ${said.t}` : said.status;
            lines.push(`${tier.padEnd(9)} ${words}`);
        }
        $('see-cell').textContent = lines.join('\n');
    }

    function repaint() {
        for (const [name, tile] of tiles)
            if (tile.said)
                paint(tile.canvas, tile.said);
        tellCell();
    }

    function moveCursor(event) {
        const moves = { ArrowLeft: -1, ArrowRight: 1, ArrowUp: -SIDE, ArrowDown: SIDE };
        const by = moves[event.key], to = cursor + by;
        const isSide = Math.abs(by) === 1 && Math.floor(to / SIDE) !== Math.floor(cursor / SIDE);
        if (by === undefined || isCommand(event) || isSide || to < 0 || to >= COUNT)
            return;
        event.preventDefault();
        cursor = to;
        repaint();
    }

    function pointCursor(event) {
        const box = event.currentTarget.getBoundingClientRect();
        const at = (x, size) => Math.min(SIDE - 1, Math.max(0, Math.floor(x / size * SIDE)));
        cursor = at(event.clientX - box.left, box.width) +
                 SIDE * at(event.clientY - box.top, box.height);
        repaint();
    }

    /* Controls. */

    function showControls() {
        const { shape, place } = state, names = Object.keys(OBJECTS[shape].places);
        if (!names.includes(place))
            state.place = names[0];
        $('see-place').replaceChildren(...names.map(name => element('option', {}, name)));
        $('see-shape').value = shape;
        $('see-place').value = state.place;
        for (const name of ['around', 'far'])
            $(`see-${name}`).value = state[name];
        $('see-around-is').textContent = `${state.around}°`;
        $('see-far-is').textContent = `${grouped(Math.round(10 ** state.far))} sizes`;
        PRESETS.forEach(([, wanted], i) => $('see-presets').children[i].setAttribute(
            'aria-pressed', String(Object.keys(wanted).every(key => wanted[key] === state[key]))));
    }

    function showZoom() {
        const { ulps, step, most, zoom } = window_, slider = $('see-zoom');
        slider.max = most;
        slider.value = zoom;
        const words = ulps === 1 ? 'neighbours are neighbouring doubles: 1 ulp'
                                 : `a step is ${grouped(ulps)} ulps of d`;
        $('see-zoom-is').textContent = `${words}, ${step.toExponential(1)}`;
        slider.setAttribute('aria-valuetext', words);
    }

    function draw() {
        frame = 0;
        showControls();
        window_ = makeWindow();
        showZoom();
        const numbers = Float64Array.from(Object.values(window_.object).flat());
        exact = hits(state.shape, 'exact', window_.rays, numbers, { normals: false });
        showWhole();
        for (const tier of tiers)
            show(tier, hits(state.shape, tier, window_.rays, numbers, { normals: false }));
        askOwn();
        tellCell();
        $('see').dataset.drawn = performance.now();
    }

    function change(to) {
        Object.assign(state, to);
        frame ||= requestAnimationFrame(() => {
            draw();
            history.replaceState(null, '', hashOf('see', state));
        });
    }

    function makeTile(name) {
        const side = name === 'where' ? WHOLE : SIDE;
        const canvas = element('canvas', { width: side, height: side, role: 'img',
                                           'aria-label': name === 'where' ? 'the whole object'
                                                                          : name });
        const caption = element('figcaption');
        if (name !== 'where') {
            canvas.tabIndex = 0;
            canvas.addEventListener('keydown', moveCursor);
            canvas.addEventListener('pointerdown', pointCursor);
        }
        tiles.set(name, { canvas, caption });
        return element('figure', { 'data-tile': name }, canvas, caption);
    }

    $('see-tiles').append(...['where', ...tiers, 'yours'].map(makeTile));
    $('see-shape').append(...Object.keys(OBJECTS).map(name => element('option', {}, name)));
    $('see-presets').append(...PRESETS.map(([words, to]) =>
        element('button', { type: 'button', onclick: () => change(to) }, words)));
    for (const name of ['shape', 'place', 'around', 'far', 'zoom'])
        $(`see-${name}`).addEventListener('input', event => change(
            { [name]: event.target.type === 'range' ? Number(event.target.value)
                                                    : event.target.value }));
    $('see-controls').addEventListener('submit', event => event.preventDefault());
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => draw());

    return {
        /* What an address says, where it says what there is. */
        open(said) {
            if (Object.hasOwn(OBJECTS, said.shape))
                Object.assign(state, { shape: said.shape, place: said.place });
            for (const name of ['around', 'far', 'zoom'])
                if (said[name] !== undefined && Number.isFinite(Number(said[name])))
                    state[name] = Math.min(Math.max(Number(said[name]), Number($(`see-${name}`).min)),
                                           name === 'zoom' ? 64 : Number($(`see-${name}`).max));
            draw();
        },
        hash: () => hashOf('see', state),
    };
}
