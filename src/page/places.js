// SPDX-License-Identifier: MIT
/* Objects of size 1 about the origin, and the places on them where formulas go wrong. */

const add = (a, b, by = 1) => a.map((x, i) => x + by * b[i]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                         a[0] * b[1] - a[1] * b[0]];
const unit = a => a.map(x => x / Math.hypot(...a));

/* Of a circle about `centre`, across the axis. */
function circlePoint(centre, axis, radius, angle) {
    const u = unit(cross(axis, [1, 0.3, 0.2])), v = unit(cross(axis, u));
    return add(add(centre, u, radius * Math.cos(angle)), v, radius * Math.sin(angle));
}

const BASE = [-0.3, -0.8, 0.2], TOP = [0.3, 0.8, -0.1], AXIS = add(TOP, BASE, -1);
const LOW = [-0.7, -0.6, -0.5], HIGH = [0.7, 0.6, 0.5];

/* A place is a point of the boundary by an angle; null: where the object ends to the eye. */
export const OBJECTS = {
    sphere: { object: { centre: [0, 0, 0], radius: 1 }, places: { limb: null } },
    cylinder: {
        object: { base: BASE, top: TOP, radius: 0.55 },
        places: { limb: null, rim: angle => circlePoint(TOP, AXIS, 0.55, angle) },
    },
    cone: {
        object: { base: BASE, apex: TOP, radius: 0.75 },
        places: {
            apex: () => TOP, limb: null, rim: angle => circlePoint(BASE, AXIS, 0.75, angle),
        },
    },
    box: {
        object: { low: LOW, high: HIGH },
        places: {
            corner: () => HIGH, limb: null,
            edge: angle => [HIGH[0], LOW[1] + (HIGH[1] - LOW[1]) * angle / (2 * Math.PI), HIGH[2]],
        },
    },
    disc: { object: { centre: [0, 0, 0], normal: [0.3, 0.8, 0.5], radius: 1 },
            places: { rim: null } },
    plane: { object: { point: [0, -0.4, 0], normal: [0.1, 1, 0.2] }, places: { horizon: null } },
};

/* From where the eye looks, at a distance. */
export function eyeAt(far) {
    return unit([0.34, 0.27, 0.9]).map(x => x * far);
}

/* The direction from the eye to the place: of a limb the last one that hits, by bisection, down to
 * neighbouring doubles. `isHit` tells of a direction. */
export function directionTo(shape, place, angle, eye, isHit) {
    const point = OBJECTS[shape].places[place];
    if (point)
        return add(point(angle), eye, -1);
    const middle = add(OBJECTS[shape].object.point ?? [0, 0, 0], eye, -1);
    const along = by => [middle[0] + by * Math.cos(angle), middle[1] + by * Math.sin(angle),
                         middle[2]];
    let hit = 0, miss = 4;
    while (miss < 1e12 && isHit(along(miss)))
        miss *= 2;
    for (let by; (by = hit + (miss - hit) / 2) !== hit && by !== miss;) {
        if (isHit(along(by)))
            hit = by;
        else
            miss = by;
    }
    return along(hit);
}

/* Of the numbers about x: the distance of one from the next. */
export function ulpOf(x) {
    const bits = new DataView(new ArrayBuffer(8));
    bits.setFloat64(0, Math.abs(x));
    bits.setBigUint64(0, bits.getBigUint64(0) + 1n);
    return bits.getFloat64(0) - Math.abs(x);
}
