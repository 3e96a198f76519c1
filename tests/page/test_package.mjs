// SPDX-License-Identifier: MIT
/* The package answers as the native library does, bit for bit, and as the vectors say:
 *
 *     node test_package.mjs PACKAGE NATIVE SPHERE SUREHIT VECTORS [CASES]
 *
 * PACKAGE is a folder where it is installed; CASES of each shape and regime, 60 unless told. */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { gzipSync } from 'node:zlib';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import test from 'node:test';

const [folder, native, sphereLibrary, surehit, vectors, cases = '60'] = process.argv.slice(2);
const found = createRequire(join(resolve(folder), 'none.js'));
const library = await import(pathToFileURL(found.resolve('surehit')));
const judging = await import(pathToFileURL(found.resolve('surehit/judge')));
const { shapes, tiers, statuses, parts, hit, hits, occluded, interval, check, stage } = library;

const bits = new DataView(new ArrayBuffer(8));
const fromBits = hex => (bits.setBigUint64(0, BigInt('0x' + hex)), bits.getFloat64(0));
const run = (...words) => execFileSync(...words, { maxBuffer: 2 ** 31 });

function doublesOf(buffer) {
    return new Float64Array(buffer.buffer.slice(buffer.byteOffset,
                                                buffer.byteOffset + buffer.length));
}

const same = (a, b) => Object.is(a, b) || (Number.isNaN(a) && Number.isNaN(b));

/* What differs in case i, of the native row and of what was made and said here; '' for nothing. */
function difference(row, made, said, numbers, i) {
    for (let k = 0; k < 8; k++)
        if (!same(row[k], made.rays[8 * i + k]))
            return `number ${k} of the ray`;
    for (let k = 0; k < numbers; k++)
        if (!same(row[8 + k], made.objects[numbers * i + k]))
            return `number ${k} of the object`;
    const at = 8 + numbers;
    if (row[at] !== said.status[i])
        return 'status';
    if (statuses[row[at]] !== 'hit')
        return '';
    for (const [k, name] of ['part', 'leaves', 't', 'tError'].entries())
        if (!same(row[at + 1 + k], said[name][i]))
            return `${name} ${said[name][i]}, not ${row[at + 1 + k]}`;
    for (let k = 0; k < 3; k++)
        if (!same(row[at + 5 + k], said.normal[3 * i + k]))
            return `number ${k} of the normal`;
    return '';
}

/* One shape and tier: all of its regimes, in one go. */
function compare(shape, tier, count) {
    const is = doublesOf(run(native, [shape, tier, count]));
    const numbers = judging.cases(shape, 'typical', { count: 1 }).objects.length;
    const size = 8 + numbers + 8;
    let compared = 0, hitCount = 0;
    for (const regime of judging.regimes.filter(name => judging.applies(shape, name))) {
        const made = judging.cases(shape, regime, { count, seed: 0 });
        const said = hits(shape, tier, made.rays, made.objects);
        for (let i = 0; i < count; i++, compared++) {
            const row = is.subarray(compared * size, (compared + 1) * size);
            const found = difference(row, made, said, numbers, i);
            if (found)
                assert.fail(`${shape} ${regime} ${tier}, case ${i}: ${found}`);
            hitCount += statuses[said.status[i]] === 'hit';
        }
    }
    assert.equal(is.length, compared * size, 'as many cases as the native library was asked');
    assert(hitCount > compared / 10);
    return compared;
}

test('answers are the native ones, bit for bit', () => {
    let sum = 0;
    for (const shape of shapes)
        for (const tier of tiers)
            sum += compare(shape, tier, Number(cases));
    console.log(`${sum} answers`);
});

function* vectorLines(at) {
    for (const entry of readdirSync(at, { withFileTypes: true })) {
        if (entry.isDirectory()) {
            yield* vectorLines(join(at, entry.name));
            continue;
        }
        if (!entry.name.endsWith('.jsonl'))
            continue; // the record of worst cases
        const [head, ...lines] = readFileSync(join(at, entry.name), 'utf8').trim().split('\n');
        for (const line of lines)
            yield [JSON.parse(head).shape, JSON.parse(line)];
    }
}

test('vectors, one ray at a time', () => {
    let count = 0;
    for (const [shape, line] of vectorLines(vectors)) {
        const numbers = line.case_bits.map(fromBits);
        const ray = { origin: numbers.slice(0, 3), direction: numbers.slice(3, 6),
                      tMin: numbers[6], tMax: numbers[7] };
        const object = numbers.slice(8), exact = hit(shape, 'exact', ray, object);
        const certain = hit(shape, 'certain', ray, object);
        const where = `${shape} ${line.from} ${line.number}`;
        count++;
        assert.equal(exact.status, line.answer, where);
        assert.equal(certain.status, line.answer, where);
        assert.equal(occluded(shape, 'exact', ray, object), line.answer, where);
        if (line.answer === 'invalid')
            assert.equal(exact.field, line.field, where);
        if (line.answer !== 'hit')
            continue;
        assert.equal(check(shape, ray, object), 'none');
        assert.equal(exact.part, line.part, where);
        assert.equal(certain.part, line.part, where);
        assert(same(exact.t, fromBits(line.t_bits)), where);
        assert(certain.t === exact.t || /* both may be infinite */
               Math.abs(certain.t - exact.t) <= certain.tError + exact.tError, where);
        exact.normal.forEach((n, i) => assert(same(n, fromBits(line.normal_bits[i])), where));
    }
    assert(count > 8000, `only ${count} vectors were read`);
});

/* C libraries print one subnormal in different ways. */
function valueOf(word) {
    const [, sign, whole, digits = '', power] =
        /^(-?)0x([01])(?:\.([0-9a-f]+))?p([+-]\d+)$/.exec(word) ?? [];
    if (power === undefined)
        return word;
    const size = Number(whole) + (digits ? parseInt(digits, 16) / 16 ** digits.length : 0);
    const half = Math.trunc(power / 2);
    return (sign ? -1 : 1) * size * 2 ** half * 2 ** (power - half);
}

const values = line => line.split(' ').map(valueOf);

test('lines are those of the native program', () => {
    for (const shape of shapes) {
        const lines = run(surehit, ['cases', '--shape', shape, '--count', '20']).toString();
        for (const tier of tiers) {
            const answers = run(surehit, ['answer', '--tier', tier], { input: lines }).toString();
            lines.trim().split('\n').forEach((line, i) => {
                const { shape: of, ray, object } = judging.readCase(line);
                assert.deepEqual(values(judging.caseLine(of, ray, object)), values(line));
                assert.deepEqual(values(judging.answerLine(of, tier, ray, object)),
                                 values(answers.split('\n')[i]));
                assert.equal(occluded(of, tier, ray, object), answers.split('\n')[i].split(' ')[0]);
            });
        }
    }
});

test('cases of a regime go on where others end', () => {
    const all = judging.cases('cone', 'rim', { count: 50, seed: 3 });
    const later = judging.cases('cone', 'rim', { count: 20, seed: 3, first: 30 });
    assert.deepEqual(later.rays, all.rays.slice(8 * 30));
    assert.deepEqual(later.objects, all.objects.slice(7 * 30));
});

test('one ray: intervals, stages, what is missing', () => {
    const ray = { origin: [0, 0, 0], direction: [0, 0, -1] };
    const sphere = { centre: [0, 0, -5], radius: 1 };
    assert.deepEqual(hit('sphere', 'exact', ray, sphere),
                     { status: 'hit', t: 4, tError: 2 ** -51 , part: 'surface',
                       leaves: false, normal: [0, 0, 1] });
    assert.deepEqual(interval('sphere', 'exact', ray, sphere),
                     { status: 'hit', tEnter: 4, tLeave: 6,
                       enterPart: 'surface', leavePart: 'surface' });
    const tube = { base: [0, 0, -5], top: [0, 4, -5], radius: 1 };
    const slanted = { origin: [0, -1, -5], direction: [0.25, 1, 0] };
    assert.deepEqual(interval('cylinder', 'exact', slanted, tube),
                     { status: 'hit', tEnter: 1, tLeave: 4,
                       enterPart: 'base', leavePart: 'wall' });
    assert.equal(stage('sphere', 'certain', ray, sphere), 'double');
    assert.deepEqual(hit('sphere', 'exact', ray, { ...sphere, radius: -1 }),
                     { status: 'invalid', field: 'radius' });
    assert.throws(() => hit('sphere', 'exact', ray, { centre: [0, 0, 0] }), /sphere.radius/);
    assert.throws(() => hit('ball', 'exact', ray, sphere), /ball/);
    assert.throws(() => hit('sphere', 'exact', { origin: [0, 0], direction: [0, 0, 1] }, sphere),
                  /ray.origin/);
    assert.throws(() => hit('sphere', 'right', ray, sphere), /right/);
    assert.throws(() => hits('sphere', 'exact', new Float64Array(9), new Float64Array(4)), /rays/);
    assert.throws(() => hits('sphere', 'exact', new Float64Array(8), new Float64Array(5)),
                  /objects/);
});

test('what is no number is refused by its name', () => {
    const rays = Float64Array.from([0, 0, 0, 0, 0, -1, 0, Infinity]), ball = [0, 0, -5, 1];
    const two = Float64Array.from([...rays, ...rays]);
    const list = { length: 8, ...[...ball, ...ball] }; /* as arguments are: neither array nor view */
    for (const objects of [ball, Float64Array.from(ball), Float32Array.from(ball)])
        assert.equal(hits('sphere', 'exact', rays, objects).t[0], 4);
    for (const objects of [ball, [...ball, ...ball], list])
        assert.deepEqual([...hits('sphere', 'exact', two, objects).t], [4, 4]);
    for (const objects of [[0, 0, -5, null], ['0', '0', '-5', '1'], '0001', [0, 0, -5, undefined],
                           [0, 0, -5, true], [0, 0, -5, [1]], [0n, 0n, -5n, 1n], new Array(4),
                           new BigInt64Array(4), new DataView(new ArrayBuffer(32)), null])
        assert.throws(() => hits('sphere', 'exact', rays, objects),
                      { name: 'TypeError', message: /^objects is to be 4 numbers/ });
    assert.throws(() => hits('sphere', 'exact', two, [...ball, ...ball.map(String)]),
                  { name: 'TypeError', message: /^objects is to be 8 numbers/ });
    const refused = (what, value, call) =>
        assert.throws(() => call({ shapes: ['sphere'], regimes: ['typical'], [what]: value }),
                      { name: 'TypeError', message: new RegExp(`^${what} is to be a whole number`) },
                      `${what}: ${String(value)}`);
    const made = options => judging.cases('sphere', 'typical', options);
    const judged = options => judging.judge(() => null, options);
    for (const value of [-1, 1.5, NaN, Infinity, 2 ** 53, '3', 3n, null, true]) {
        for (const what of ['count', 'seed', 'first'])
            refused(what, value, made);
        for (const what of ['count', 'seed'])
            refused(what, value, judged);
    }
    refused('count', 0, judged);
    for (const [what, value] of [['shapes', 'sphere'], ['shapes', {}], ['regimes', 'typical']])
        assert.throws(() => judged({ [what]: value }),
                      { name: 'TypeError', message: `${what} is to be a list of names` });
    assert.equal(made({ count: 0, seed: 2 ** 53 - 1, first: 2 ** 53 - 1 }).rays.length, 0);
});

/* Many rays and one object; more than the room holds. */
test('many rays are single ones', () => {
    const count = 2500, rays = new Float64Array(8 * count), cone = [0, 0, 0, 0, 0, 2, 1];
    for (let i = 0; i < count; i++)
        rays.set([i / 1000 - 1.25, 0.1, -3, 0, 0, 1, 0, Infinity], 8 * i);
    const said = hits('cone', 'certain', rays, Float64Array.from(cone));
    for (let i = 0; i < count; i++) {
        const one = hit('cone', 'certain', rays.subarray(8 * i, 8 * i + 8), cone);
        assert.equal(statuses[said.status[i]], one.status);
        assert(same(said.t[i], one.t ?? NaN));
        if (one.status === 'hit')
            assert.deepEqual([parts[said.part[i]], ...said.normal.subarray(3 * i, 3 * i + 3)],
                             [one.part, ...one.normal]);
    }
    assert.equal(hits('cone', 'certain', rays, Float64Array.from(cone), { normals: false }).normal,
                 undefined);
});

test('sizes', () => {
    for (const [name, most] of [['surehit.wasm', 150e3], ['judge.wasm', 250e3]]) {
        const size = gzipSync(readFileSync(found.resolve(`surehit/${name}`)), { level: 9 }).length;
        console.log(`${name}: ${size} bytes compressed`);
        assert(size <= most);
    }
});

/* Nanoseconds a ray, of the least of some rounds: an engine compiles again what it is asked often. */
function timeOf(shape, tier, count) {
    const { rays, objects } = judging.cases(shape, 'typical', { count });
    let least = Infinity;
    for (let round = 0; round < 400; round++) {
        const before = process.cpuUsage();
        hits(shape, tier, rays, objects, { normals: false });
        const { user, system } = process.cpuUsage(before);
        least = Math.min(least, (user + system) * 1000 / count);
    }
    return least;
}

/* Beside native rays one by one. Each shape for itself may be slower or faster, by what others do to
 * caches and to clocks: the middle is held. */
test('ordinary rays take some times the native time', () => {
    const count = 20000, ratios = [];
    process.env.SUREHIT_LANES = '1';
    for (const shape of shapes) {
        const is = timeOf(shape, 'certain', count);
        const other = Number(run(native, [shape, 'certain', count, 'time']));
        ratios.push(is / other);
        console.log(`${shape}: ${is.toFixed(1)} ns, native ${other}: ${(is / other).toFixed(2)}`);
    }
    const middle = ratios.sort((a, b) => a - b).slice(2, 4).reduce((a, b) => a + b) / 2;
    assert(middle < 3, `${middle} times as long`);
});

/* The routine of sphere.c. */
function sphere(ray, { centre, radius }) {
    let a = 0, half = 0, c = -radius * radius;
    for (let i = 0; i < 3; i++) {
        const m = ray.origin[i] - centre[i], d = ray.direction[i];
        a += d * d;
        half += m * d;
        c += m * m;
    }
    const root = Math.sqrt(half * half - a * c), near = (-half - root) / a;
    const t = near >= ray.tMin ? near : (-half + root) / a;
    return t >= ray.tMin && t <= ray.tMax ? { t } : null;
}

/* As JSON has it: without what the native judge alone tells, in 9 digits, infinity as null. */
function comparable(found) {
    const left = ['t_ulps_by_powers_of_two', 'nanoseconds', 'instructions'];
    return JSON.parse(JSON.stringify(found, (key, value) =>
        left.includes(key) ? undefined
                           : typeof value === 'number' ? Number(value.toPrecision(9)) : value));
}

test('the judge tells what the native one does', () => {
    for (const [options, words] of [[{}, []],
                                    [{ entry: 'unit touch=miss', margin: 'ulps', seed: 7 },
                                     ['--entry', 'unit touch=miss', '--margin', 'ulps',
                                      '--seed', '7']]]) {
        const made = judging.judge(sphere, { shapes: ['sphere'], count: 100, ...options });
        const to = join(mkdtempSync(join(tmpdir(), 'surehit-')), 'found.json');
        run(surehit, ['judge', '--candidate', sphereLibrary, '--shape', 'sphere', '--count', '100',
                      '--json', to, ...words]);
        const json = JSON.parse(readFileSync(to, 'utf8'));
        assert.deepEqual(comparable(made.rows), comparable(json.rows));
        assert.deepEqual(made.conventions, json.conventions);
        const known = json.worst.map(one => Object.fromEntries(
            Object.entries(one).filter(([, value]) => value !== null)));
        assert.deepEqual(comparable(made.worst), comparable(known));
        assert(made.rows.some(row => row.wrong > 0) && made.worst.length > 2);
    }
});

test('a judge of floats asks with floats', () => {
    for (const float of [false, true]) {
        let floats = true;
        judging.judge((ray, { centre }) => {
            floats &&= [...ray.origin, ...ray.direction, ...centre].every(x => same(Math.fround(x), x));
        }, { shapes: ['sphere'], regimes: ['typical'], count: 20, float });
        assert.equal(floats, float);
    }
});

test('who throws, or answers what is no answer, is told so', () => {
    const options = { shapes: ['sphere'], regimes: ['typical', 'inside'], count: 50 };
    const thrower = judging.judge((ray, s) => { throw new RangeError('not today'); }, options);
    assert.equal(thrower.rows[0].faults.crash > 15, true);
    assert.match(String(thrower.thrown[0]), /not today/);
    assert.equal(thrower.worst.find(one => one.kind === 'crash').answer, 'it threw an exception');
    const liar = judging.judge(() => ({ t: 1, part: 'roof' }), options);
    assert.equal(liar.rows.every(row => row.faults['wrong part'] > 0), true);
    const poet = judging.judge(() => 'perhaps', options);
    assert.equal(poet.rows[0].faults.garbage, 50);
    for (const normal of [[NaN, NaN, NaN], [NaN, NaN, 1], 'abc', 5, { x: 1 }, ['0', '0', '1']])
        assert(judging.judge(() => ({ t: 1, normal }), options).rows[0].faults['not a number'] > 0);
    for (const normal of [undefined, null, [0, 0, 1]]) {
        const [row] = judging.judge(() => ({ t: 1, normal }), options).rows;
        assert.equal(row.faults['not a number'] ?? 0, 0);
    }
    assert.throws(() => judging.judge('x', options), { name: 'TypeError', message: /^routine / });
    let n = 0;
    const moody = judging.judge(() => ({ t: n++ }), options);
    assert(moody.rows[0].faults['answer changes'] > 0);
    assert.throws(() => judging.judge(sphere, { ...options, entry: 'round' }), /round/);
    assert.throws(() => judging.judge(sphere, { shapes: ['plane'], regimes: ['apex'] }), /regime/);
});

test('who asks for a judge while one is running is refused, and that one stays whole', () => {
    const options = { shapes: ['sphere'], regimes: ['typical', 'tiny'], count: 50 };
    const alone = judging.judge(sphere, options), refused = [];
    const again = () => {
        try {
            judging.judge(() => 1, options);
        } catch (error) {
            refused.push(error.message);
        }
    };
    const told = judging.judge(sphere, { ...options, onRow: again });
    const asked = judging.judge((...words) => (again(), sphere(...words)), options);
    assert.deepEqual([told, asked], [alone, alone]);
    assert.match(refused[0], /judge is running/);
    assert.equal(new Set(refused).size, 1);
    const thrower = judging.judge(() => judging.judge(sphere, options), options);
    assert.match(thrower.thrown[0].message, /judge is running/);
    const ended = () => judging.judge(sphere, { ...options, onRow() { throw new Error('stop'); } });
    assert.throws(ended, /stop/);
    assert.throws(() => judging.judge(sphere, { ...options, entry: 'x'.repeat(9999) }), /too long/);
    assert.deepEqual(judging.judge(sphere, options), alone);
});
