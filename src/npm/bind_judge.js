// SPDX-License-Identifier: MIT
/* Cases and the judge over an instance of its WebAssembly: src/wasm/cases.c, judge.c. */
import { bind, indexOf, instance, textAt, words } from './bind.js';

const encoder = new TextEncoder();
const ANSWER = 6; /* doubles: status, t, part, normal */

/* The facts that are being told, as an object of objects: a/b is b of a. */
function factsOf(wasm) {
    const all = {};
    for (let i = 0; i < wasm.facts_count(); i++) {
        const path = textAt(wasm, wasm.fact_name(i)).split('/'), last = path.pop();
        let of = all;
        path.forEach((name, depth) => {
            of = of[name] ??= (path[depth + 1] ?? last) === '0' ? [] : {};
        });
        of[last] = textAt(wasm, wasm.fact_words(i)) ?? wasm.fact_number(i);
    }
    return all;
}

function writeText(wasm, at, size, text) {
    const bytes = encoder.encode(text);
    if (bytes.length >= size || bytes.includes(0))
        throw new TypeError(`'${text.slice(0, 40)}...' is too long, or has a 0 in it`);
    new Uint8Array(wasm.memory.buffer, at, size).fill(0).set(bytes);
}

function checkWhole(value, what, least = 0) {
    if (!Number.isSafeInteger(value) || value < least)
        throw new TypeError(`${what} is to be a whole number from ${least} to 2 ** 53 - 1`);
}

function checkNames(list, names, what) {
    if (!Array.isArray(list))
        throw new TypeError(`${what}s is to be a list of names`);
    list.forEach(name => indexOf(name, names, `the ${what}`));
}

const idle = () => 0; /* is asked while no judge is running */

export function bindJudge(module) {
    let ask = idle;
    const wasm = instance(module, (questions, answers) => ask(questions, answers));
    const library = bind(wasm);
    const { shapes, statuses, parts, tiers, inner } = library;
    const regimes = words(wasm, wasm.regime_word), units = words(wasm, wasm.margin_word);

    const applies = (shape, regime) => wasm.regime_has(indexOf(shape, shapes, 'the shape'),
                                                       indexOf(regime, regimes, 'the regime')) === 1;

    function cases(shape, regime, { count = 1000, seed = 0, first = 0 } = {}) {
        if (!applies(shape, regime))
            throw new TypeError(`a ${shape} has no ${regime}`);
        checkWhole(count, 'count');
        checkWhole(seed, 'seed');
        checkWhole(first, 'first');
        const of = shapes.indexOf(shape), { numbers } = inner.rows[of];
        const rays = new Float64Array(8 * count), objects = new Float64Array(numbers * count);
        for (let at = 0; at < count; at += inner.room) {
            const size = Math.min(inner.room, count - at), view = inner.view();
            wasm.make_cases(size, of, regimes.indexOf(regime), seed, first + at);
            rays.set(view.rays.subarray(0, 8 * size), 8 * at);
            objects.set(view.objects.subarray(0, numbers * size), numbers * at);
        }
        return { rays, objects };
    }

    function caseLine(shape, ray, object) {
        const [of] = inner.put(shape, tiers[0], ray, object);
        return textAt(wasm, wasm.case_line(0, of));
    }

    function answerLine(shape, tier, ray, object) {
        const [of, by] = inner.put(shape, tier, ray, object);
        return textAt(wasm, wasm.answer_line(0, of, by));
    }

    /* Number `at` of doubles as the objects that a routine is asked with. */
    function rayAt(list, at) {
        return {
            origin: [list[at], list[at + 1], list[at + 2]],
            direction: [list[at + 3], list[at + 4], list[at + 5]],
            tMin: list[at + 6], tMax: list[at + 7],
        };
    }

    function objectAt(shape, list, at) {
        const object = {};
        for (const { name, at: field, size } of inner.rows[shape].fields)
            object[name] = size === 1 ? list[at + field]
                                      : Array.from(list.subarray(at + field, at + field + size));
        return object;
    }

    function readCase(line) {
        writeText(wasm, wasm.line_room(), wasm.line_size(), line);
        const shape = wasm.case_from_line();
        if (shape < 0)
            throw new TypeError(`no case: '${line}'`);
        const { rays, objects } = inner.view();
        return { shape: shapes[shape], ray: rayAt(rays, 0), object: objectAt(shape, objects, 0) };
    }

    /* Three NaNs: it is not told. What is, and is no normal, has another number beside NaNs. */
    function putNormal(normal, to, at) {
        if (normal === undefined || normal === null)
            return;
        for (let i = 0; i < 3; i++)
            to[at + i] = typeof normal[i] === 'number' ? normal[i] : NaN;
        if (to.subarray(at, at + 3).every(Number.isNaN))
            to[at] = Infinity;
    }

    /* A routine's answer as doubles; a status that is none is garbage. */
    function putAnswer(said, to, at) {
        const code = word => statuses.indexOf(word);
        const number = value => typeof value === 'number' ? value : NaN;
        to.fill(NaN, at, at + ANSWER);
        if (said === null || said === undefined || said === false || said === 'miss') {
            to[at] = code('miss');
        } else if (said === 'invalid' || said === true) {
            to[at] = code(said === true ? 'hit' : 'invalid');
        } else if (typeof said === 'number' || (typeof said === 'object' && 't' in said)) {
            to[at] = code('hit');
            to[at + 1] = number(said.t ?? said);
            if (said.part !== undefined && said.part !== null) {
                const part = parts.indexOf(said.part);
                to[at + 2] = part < 0 ? parts.length : part;
            }
            putNormal(said.normal, to, at + 3);
        } else {
            to[at] = -1;
        }
    }

    /* Asks a routine; what it throws first is kept. */
    function asking(routine, thrown) {
        return (questions, answers) => {
            const [shape, count] = new Float64Array(wasm.memory.buffer, questions, 2);
            const { numbers } = inner.rows[shape], size = 8 + numbers;
            const list = new Float64Array(wasm.memory.buffer, questions + 16, size * count);
            const to = new Float64Array(wasm.memory.buffer, answers, ANSWER * count);
            for (let i = 0; i < count; i++) {
                try {
                    putAnswer(routine(rayAt(list, size * i), objectAt(shape, list, size * i + 8),
                                      shapes[shape]), to, ANSWER * i);
                } catch (error) {
                    thrown.push(error);
                    thrown.length = Math.min(thrown.length, 8);
                    return i;
                }
            }
            return count;
        };
    }

    /* What is asked of which shapes: rows. */
    function rowsOf(options) {
        const wanted = options.shapes ?? shapes, by = options.regimes ?? regimes;
        checkNames(wanted, shapes, 'shape');
        checkNames(by, regimes, 'regime');
        const rows = shapes.filter(shape => wanted.includes(shape)).flatMap(shape =>
            regimes.filter(regime => by.includes(regime) && applies(shape, regime))
                   .map(regime => [shape, regime]));
        if (rows.length === 0)
            throw new TypeError('no such shape has such a regime');
        return rows;
    }

    function judge(routine, options = {}) {
        const { count = 2000, seed = 0, margin = 'size', entry = '', float = false,
                onRow = () => {} } = options;
        if (typeof routine !== 'function')
            throw new TypeError('routine is to be a function');
        if (ask !== idle) /* the module has room for one */
            throw new Error('a judge is running, and there is one at a time');
        const asked = rowsOf(options), found = { rows: [], conventions: {}, worst: [], thrown: [] };
        const check = message => {
            if (message !== 0)
                throw new TypeError(textAt(wasm, message));
        };
        checkWhole(count, 'count', 1);
        checkWhole(seed, 'seed');
        ask = asking(routine, found.thrown);
        try {
            writeText(wasm, wasm.judge_entry(), wasm.judge_entry_size(), entry);
            check(wasm.judge_open(float ? 1 : 0, indexOf(margin, units, 'the margin'), seed));
            for (const [shape, regime] of asked) {
                check(wasm.judge_row(shapes.indexOf(shape), regimes.indexOf(regime), count));
                found.rows.push(factsOf(wasm));
                onRow(found.rows.at(-1), asked.length);
            }
            for (const shape of new Set(asked.map(row => row[0]))) {
                wasm.judge_conventions(shapes.indexOf(shape));
                found.conventions[shape] = factsOf(wasm);
            }
            for (let i = 0, worst = wasm.judge_worst(); i < worst; i++) {
                wasm.judge_worst_tell(i);
                found.worst.push(factsOf(wasm));
            }
        } finally {
            wasm.judge_close();
            ask = idle;
        }
        return found;
    }

    return {
        ...library, regimes, margins: units, applies, cases, caseLine, answerLine, readCase, judge,
        inner: { ...inner, putAnswer, ANSWER },
    };
}
