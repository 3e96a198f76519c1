// SPDX-License-Identifier: MIT
/* The library's functions over an instance of its WebAssembly: src/wasm/library.c. */

/* What C's library asks of whoever runs it. Nothing here has files: each is a bad number (8). */
function system(module, memory) {
    const asked = {
        clock_time_get(clock, precision, at) {
            const now = BigInt(Math.round(performance.now() * 1e6));
            new DataView(memory().buffer).setBigUint64(at, now, true);
            return 0;
        },
        proc_exit(status) {
            throw new Error(`exit ${status}`);
        },
    };
    for (const { module: from, name } of WebAssembly.Module.imports(module))
        if (from === 'wasi_snapshot_preview1')
            asked[name] ??= () => 8;
    return asked;
}

/* What an instance of a module exports; `ask` is for the judge's. */
export function instance(module, ask = () => 0) {
    const made = new WebAssembly.Instance(module, {
        surehit: { ask },
        wasi_snapshot_preview1: system(module, () => made.exports.memory),
    });
    made.exports._initialize();
    return made.exports;
}

const decoder = new TextDecoder();

/* Text at an address, null at none. */
export function textAt(wasm, at) {
    if (at === 0)
        return null;
    const bytes = new Uint8Array(wasm.memory.buffer, at);
    return decoder.decode(bytes.slice(0, bytes.indexOf(0)));
}

export function words(wasm, name) {
    const all = [];
    for (let word; (word = textAt(wasm, name(all.length))) !== null;)
        all.push(word);
    return Object.freeze(all);
}

/* Which of these words it is. */
export function indexOf(word, all, what) {
    const at = all.indexOf(word);
    if (at < 0)
        throw new TypeError(`${what} is '${word}', and none of ${all.join(', ')}`);
    return at;
}

/* A shape's fields: {name, at, size}. */
function fieldsOf(wasm, shape, names) {
    const fields = [], numbers = wasm.shape_numbers(shape);
    for (let i = 0, field; (field = wasm.shape_field(shape, i)) >= 0; i++)
        fields.push({ name: names[field], at: wasm.shape_field_at(shape, i) });
    fields.forEach((field, i) => {
        field.size = (i + 1 < fields.length ? fields[i + 1].at : numbers) - field.at;
    });
    return { numbers, fields };
}

/* Takes a number, or so many of them, out of what a caller wrote. */
function take(value, size, what, to, at) {
    const list = size === 1 ? [value] : value;
    if (list === null || typeof list !== 'object' || list.length !== size)
        throw new TypeError(`${what} is to be ${size === 1 ? 'a number' : `${size} numbers`}`);
    for (let i = 0; i < size; i++) {
        if (typeof list[i] !== 'number')
            throw new TypeError(`${what} is to be ${size === 1 ? 'a number' : `${size} numbers`}`);
        to[at + i] = list[i];
    }
}

const isList = value => Array.isArray(value) || ArrayBuffer.isView(value);

export function bind(wasm) {
    const shapes = words(wasm, wasm.shape_name), tiers = words(wasm, wasm.tier_name);
    const statuses = words(wasm, wasm.status_name), parts = words(wasm, wasm.part_name);
    const fieldNames = words(wasm, wasm.field_name), stages = words(wasm, wasm.stage_name);
    const rows = shapes.map((_, shape) => fieldsOf(wasm, shape, fieldNames));
    const room = wasm.room_size(), MISS = statuses.indexOf('miss'), HIT = statuses.indexOf('hit');
    let views;

    /* Memory that grows leaves its old views behind. */
    function view() {
        const buffer = wasm.memory.buffer;
        if (views?.buffer === buffer)
            return views;
        const doubles = (at, size) => new Float64Array(buffer, at, room * size);
        const bytes = at => new Uint8Array(buffer, at, room);
        return views = {
            buffer,
            rays: doubles(wasm.room_rays(), 8),
            objects: doubles(wasm.room_objects(), Math.max(...rows.map(row => row.numbers))),
            t: doubles(wasm.room_t(), 1),
            tError: doubles(wasm.room_t_error(), 1),
            normal: doubles(wasm.room_normal(), 3),
            status: bytes(wasm.room_status()),
            part: bytes(wasm.room_part()),
            leaves: bytes(wasm.room_leaves()),
        };
    }

    function putRay(ray, to) {
        if (isList(ray))
            return take(ray, 8, 'ray', to, 0);
        if (ray === null || typeof ray !== 'object')
            throw new TypeError('ray is to be {origin, direction, tMin, tMax}, or 8 numbers');
        take(ray.origin, 3, 'ray.origin', to, 0);
        take(ray.direction, 3, 'ray.direction', to, 3);
        take(ray.tMin === undefined ? 0 : ray.tMin, 1, 'ray.tMin', to, 6);
        take(ray.tMax === undefined ? Infinity : ray.tMax, 1, 'ray.tMax', to, 7);
    }

    function putObject(shape, object, to) {
        const { numbers, fields } = rows[shape], name = shapes[shape];
        if (isList(object))
            return take(object, numbers, name, to, 0);
        if (object === null || typeof object !== 'object')
            throw new TypeError(`${name} is to be {${fields.map(f => f.name).join(', ')}}, ` +
                                `or ${numbers} numbers`);
        for (const field of fields)
            take(object[field.name], field.size, `${name}.${field.name}`, to, field.at);
    }

    /* Writes a ray and an object into the room, and returns the numbers of shape and tier. */
    function put(shape, tier, ray, object) {
        const of = indexOf(shape, shapes, 'the shape'), by = indexOf(tier, tiers, 'the tier');
        putRay(ray, view().rays);
        putObject(of, object, view().objects);
        return [of, by];
    }

    const invalid = shape => ({ status: 'invalid', field: fieldNames[wasm.check(shape)] });

    function hit(shape, tier, ray, object) {
        const [of, by] = put(shape, tier, ray, object);
        wasm.hits(1, of, by, 0, 1);
        const { status, part, leaves, t, tError, normal } = view();
        if (status[0] !== HIT)
            return status[0] === MISS ? { status: 'miss' } : invalid(of);
        return {
            status: 'hit', t: t[0], tError: tError[0], part: parts[part[0]],
            leaves: leaves[0] === 1, normal: [normal[0], normal[1], normal[2]],
        };
    }

    function interval(shape, tier, ray, object) {
        const [of, by] = put(shape, tier, ray, object), status = wasm.interval(of, by);
        const { t, part } = view();
        if (status !== HIT)
            return status === MISS ? { status: 'miss' } : invalid(of);
        return {
            status: 'hit', tEnter: t[0], tLeave: t[1],
            enterPart: parts[part[0]], leavePart: parts[part[1]],
        };
    }

    function occluded(shape, tier, ray, object) {
        return statuses[wasm.occluded(...put(shape, tier, ray, object))];
    }

    function check(shape, ray, object) {
        return fieldNames[wasm.check(put(shape, tiers[0], ray, object)[0])];
    }

    function stage(shape, tier, ray, object) {
        return stages[wasm.stage(...put(shape, tier, ray, object))];
    }

    /* How many rays, whether each has its own object, and the objects as doubles. */
    function columnsOf(shape, rays, objects) {
        const { numbers } = rows[shape];
        if (!(rays instanceof Float64Array) || rays.length % 8 !== 0)
            throw new TypeError('rays is to be a Float64Array, 8 numbers a ray');
        const count = rays.length / 8, one = objects?.length === numbers;
        if (!one && objects?.length !== numbers * count)
            throw new TypeError(`objects is to be ${numbers} numbers, or as many for each ray`);
        if (objects instanceof Float64Array)
            return [count, !one, objects];
        const doubles = new Float64Array(objects.length);
        take(objects, doubles.length, 'objects', doubles, 0);
        return [count, !one, doubles];
    }

    function hits(shape, tier, rays, objects, { normals = true } = {}) {
        const of = indexOf(shape, shapes, 'the shape'), by = indexOf(tier, tiers, 'the tier');
        const [count, several, doubles] = columnsOf(of, rays, objects), { numbers } = rows[of];
        const answers = {
            status: new Uint8Array(count), part: new Uint8Array(count),
            leaves: new Uint8Array(count), t: new Float64Array(count),
            tError: new Float64Array(count),
        };
        if (normals)
            answers.normal = new Float64Array(3 * count);
        const from = view(), sizes = Object.entries(answers).map(([name, to]) =>
            [from[name], to, name === 'normal' ? 3 : 1, name !== 'status']);
        for (let first = 0; first < count; first += room) {
            const size = Math.min(room, count - first);
            from.rays.set(rays.subarray(8 * first, 8 * (first + size)));
            if (several)
                from.objects.set(doubles.subarray(numbers * first, numbers * (first + size)));
            else if (first === 0)
                from.objects.set(doubles);
            for (const [column, , width, cleared] of sizes) {
                if (cleared) /* what is no hit leaves them alone */
                    column.fill(column instanceof Float64Array ? NaN : 0, 0, width * size);
            }
            wasm.hits(size, of, by, several ? 1 : 0, normals ? 1 : 0);
            for (const [column, to, width] of sizes)
                to.set(column.subarray(0, width * size), width * first);
        }
        return answers;
    }

    return {
        shapes, tiers, statuses, parts, hit, hits, occluded, interval, check, stage,
        /* For the judge's binding, and for pages. */
        inner: { view, rows, put, putObject, fieldNames, room },
    };
}
