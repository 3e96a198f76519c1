// SPDX-License-Identifier: MIT
/* What may take long, or forever, in a thread of its own: somebody's functions, and pictures. The
 * page stops a worker by ending it. */
import { bindJudge } from '../npm/bind_judge.js';
import { bindDraw } from './bind_draw.js';
import { routinesOf, wordsOf } from './routines.js';

const ALIVE = 100; /* ms between signs of life */
const NONE = 255;  /* no status */

let judging, drawing, wanted = 0, said = 0;

/* Tells the page which function is asked, now and then. */
function alive(what) {
    const now = performance.now();
    if (now - said < ALIVE)
        return;
    said = now;
    postMessage({ kind: 'alive', what });
}

function judgeAll({ code, options }) {
    const routines = routinesOf(code, judging.shapes), shapes = Object.keys(routines);
    let asked = 0;
    if (shapes.length === 0)
        throw new Error(`no function is named ${judging.shapes.join(', ')}`);
    const routine = (ray, object, shape) => {
        asked++;
        alive(`${shape}, question ${asked}`);
        return routines[shape](ray, object);
    };
    const found = judging.judge(routine, {
        ...options, shapes, onRow: (row, of) => postMessage({ kind: 'row', row, of }),
    });
    found.thrown = found.thrown.map(wordsOf);
    postMessage({ kind: 'done', found });
}

/* Hits of one's own function for the pictures of "See it", by the judge's reading of an answer; the
 * status is none of the library's where there is no answer. */
function askOwn({ code, shape, rays, object, id }) {
    const routine = routinesOf(code, judging.shapes)[shape];
    if (!routine)
        return postMessage({ kind: 'own', id, none: true });
    const count = rays.length / 8, status = new Uint8Array(count), t = new Float64Array(count);
    const { putAnswer, ANSWER } = judging.inner, said = new Float64Array(ANSWER);
    let thrown;
    for (let i = 0; i < count; i++) {
        const [x, y, z, u, v, w, tMin, tMax] = rays.subarray(8 * i, 8 * i + 8);
        try {
            putAnswer(routine({ origin: [x, y, z], direction: [u, v, w], tMin, tMax },
                              structuredClone(object)), said, 0);
            [status[i], t[i]] = said;
        } catch (error) {
            thrown ??= wordsOf(error);
            status[i] = NONE;
        }
    }
    postMessage({ kind: 'own', id, status, t, thrown });
}

/* Now and then others may speak. */
const TURN = 40; /* ms */
let turn = 0;
async function pause() {
    if (performance.now() - turn < TURN)
        return;
    await new Promise(done => setTimeout(done));
    turn = performance.now();
}

/* Tile by tile; a newer wish ends it. */
async function drawAll({ id, text, size, tiers, check }) {
    wanted = id;
    const scene = drawing.read(text, size);
    postMessage({ kind: 'scene', id, ...scene });
    if (!scene.width)
        return;
    for (const tile of drawing.tiles(scene)) {
        for (const tier of tiers) {
            await pause();
            if (wanted !== id)
                return;
            postMessage({ kind: 'tile', id, tier, tile, ...drawing.tile(tier, tile, check) });
        }
    }
    postMessage({ kind: 'drawn', id });
}

const tasks = { judge: judgeAll, own: askOwn, draw: drawAll };

onmessage = async ({ data }) => {
    try {
        if (data.judge)
            judging = bindJudge(data.judge);
        else if (data.drawer)
            drawing = bindDraw(data.drawer);
        else
            await tasks[data.kind](data);
    } catch (error) {
        postMessage({ kind: 'error', id: data.id, message: wordsOf(error) });
    }
};
