// SPDX-License-Identifier: MIT
/* Functions to start from. */

const SPHERE = `// The sphere of textbooks, in doubles. Return t, or {t, part, normal}, or null for a miss.
function sphere(ray, { centre, radius }) {
    const [ox, oy, oz] = ray.origin, [dx, dy, dz] = ray.direction;
    const x = ox - centre[0], y = oy - centre[1], z = oz - centre[2];
    const a = dx * dx + dy * dy + dz * dz;
    const b = x * dx + y * dy + z * dz;
    const c = x * x + y * y + z * z - radius * radius;
    const root = Math.sqrt(b * b - a * c);
    const near = (-b - root) / a, far = (-b + root) / a;
    const t = near >= ray.tMin ? near : far;
    return t >= ray.tMin && t <= ray.tMax ? t : null;
}
`;

const BOX = `// The slabs of a box.
function box(ray, { low, high }) {
    let enter = -Infinity, leave = Infinity;
    for (let i = 0; i < 3; i++) {
        const one = (low[i] - ray.origin[i]) / ray.direction[i];
        const two = (high[i] - ray.origin[i]) / ray.direction[i];
        enter = Math.max(enter, Math.min(one, two));
        leave = Math.min(leave, Math.max(one, two));
    }
    const t = enter >= ray.tMin ? enter : leave;
    return enter <= leave && t >= ray.tMin && t <= ray.tMax ? t : null;
}
`;

/* As docs/examples/sphere.glsl: each operation is rounded to a float. */
const GLSL = `// A shader computes in floats: f rounds what is computed, after each operation.
const f = Math.fround;
const dot = (a, b) => f(f(f(a[0] * b[0]) + f(a[1] * b[1])) + f(a[2] * b[2]));

function sphere(ray, { centre, radius }) {
    const oc = ray.origin.map((o, i) => f(o - centre[i]));
    const a = dot(ray.direction, ray.direction);
    const b = dot(oc, ray.direction);
    const c = f(dot(oc, oc) - f(radius * radius));
    let h = f(f(b * b) - f(a * c));
    if (h < 0)
        return null;
    h = f(Math.sqrt(h));
    let t = f(f(-b - h) / a);
    if (t < ray.tMin)
        t = f(f(-b + h) / a);
    return t >= ray.tMin && t <= ray.tMax ? t : null;
}
`;

/* As sphere.c.txt: C's doubles are JavaScript's numbers. */
const C = `// C's doubles are JavaScript's numbers: + - * / and sqrt are the same, bit for bit.
function sphere(ray, { centre, radius }) {
    let b = 0, c = -radius * radius;
    for (let i = 0; i < 3; i++) {
        const m = ray.origin[i] - centre[i];
        b += m * ray.direction[i];
        c += m * m;
    }
    if (c > 0 && b > 0)
        return null;
    const square = b * b - c;
    if (square < 0)
        return null;
    const t = Math.max(-b - Math.sqrt(square), 0);
    return t >= ray.tMin && t <= ray.tMax ? t : null;
}
`;

export const EXAMPLES = {
    'JavaScript: a sphere and a box': { code: `${SPHERE}\n${BOX}` },
    'GLSL: a sphere': { code: GLSL, original: 'example-glsl', entry: 'float' },
    'C: a sphere, for unit directions': {
        code: C, original: 'example-c', entry: 'unit t_min=0 inside=0',
    },
};
