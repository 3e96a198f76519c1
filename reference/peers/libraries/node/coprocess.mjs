// SPDX-License-Identifier: MIT
/* A library's routines as a program that the judge keeps running (docs/coprocess.md), in doubles.
 *
 *     serve({ library, entry, page }, { sphere(ray, object) { ... }, ... })
 *
 * ray: ox oy oz dx dy dz t_min t_max; object: its numbers in the case line's order. Returned is
 * null for a miss, and t, or NaN for a hit without one. `--entry` prints the entry conditions,
 * `--about` all there is to say, for programs. */
import { existsSync, readFileSync, readSync, writeSync } from 'node:fs';

const SHAPES = ['plane', 'disc', 'sphere', 'cylinder', 'cone', 'box'];
const NUMBERS = [6, 7, 4, 7, 7, 6];
const RAY = 8;
const ANSWER = 6;
const MISS = 0, HIT = 1;

function take(count) {
    const numbers = new Float64Array(count), bytes = new Uint8Array(numbers.buffer);
    for (let have = 0, more; have < bytes.length; have += more) {
        more = readSync(0, bytes, have, bytes.length - have);
        if (more === 0)
            process.exit();
    }
    return numbers;
}

function give(numbers) {
    const bytes = new Uint8Array(numbers.buffer);
    for (let at = 0; at < bytes.length;)
        at += writeSync(1, bytes, at);
}

function answer(routine, shape, count) {
    const size = RAY + NUMBERS[shape], cases = take(count * size);
    const answers = new Float64Array(count * ANSWER).fill(NaN);
    for (let i = 0; i < count; i++) {
        const object = (i + 1) * size - NUMBERS[shape];
        const t = routine(cases.subarray(i * size, object), cases.subarray(object, (i + 1) * size));
        answers[i * ANSWER] = t === null ? MISS : HIT;
        answers[i * ANSWER + 1] = t === null ? 0 : t;
    }
    return answers;
}

function versionOf(library) {
    const file = new URL(`node_modules/${library}/package.json`, import.meta.url);
    return existsSync(file) ? JSON.parse(readFileSync(file)).version : '';
}

export function serve(about, routines) {
    const shapes = Object.keys(routines), version = versionOf(about.library);
    if (process.argv[2] === '--entry')
        return console.log(about.entry);
    if (process.argv[2] === '--about')
        return console.log(JSON.stringify({ ...about, version, shapes }));
    writeSync(1, `ready binary ${shapes.join(' ')} ${about.entry} name=${about.library} ` +
                 `version=${version} build=node-${process.version}\n\n`);
    for (;;) {
        const [shape, count] = take(2);
        give(answer(routines[SHAPES[shape]], shape, count));
    }
}
