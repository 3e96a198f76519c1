// SPDX-License-Identifier: MIT
/* What the types allow, and what they refuse: compiled by test_package.py. */
import { hit, hits, interval, occluded, check, stage } from 'surehit';
import type { Hit, Part, Ray } from 'surehit';
import { cases, judge, readCase, regimes } from 'surehit/judge';

const ray: Ray = { origin: [0, 0, 0], direction: new Float64Array([0, 0, -1]) };
const sphere = { centre: [0, 0, -5], radius: 1 } as const;

const found = hit('sphere', 'certain', ray, sphere);
if (found.status === 'hit') {
    const whole: Hit = found, part: Part = found.part, [x]: [number, number, number] = found.normal;
    console.log(whole.t + x, part);
} else if (found.status === 'invalid') {
    console.log(found.field);
}
const ends = interval('cone', 'exact', [0, 0, 0, 0, 0, 1, 0, 9], [0, 0, 1, 0, 0, 2, 1]);
console.log(ends.status === 'hit' && ends.tLeave, occluded('sphere', 'exact', ray, sphere));
console.log(check('sphere', ray, sphere) === 'none', stage('sphere', 'exact', ray, sphere));
const { rays, objects } = cases('box', regimes[0], { count: 10 });
const columns = hits('box', 'exact', rays, objects, { normals: false });
console.log(columns.normal?.length, readCase('').shape);
const verdict = judge((r, object: { radius: number }) => r.tMin + object.radius,
                      { shapes: ['sphere'], onRow: row => console.log(row.t_ulps['99.99']) });
console.log(verdict.rows[0].faults['false hit'], verdict.worst[0].margin);

// @ts-expect-error: no such shape
hit('torus', 'certain', ray, sphere);
// @ts-expect-error: no such tier
hit('sphere', 'right', ray, sphere);
// @ts-expect-error: a sphere has a radius
hit('sphere', 'certain', ray, { centre: [0, 0, 0] });
// @ts-expect-error: a cone has an apex
hit('cone', 'certain', ray, sphere);
// @ts-expect-error: it may be no hit
console.log(found.t);
// @ts-expect-error: 8 numbers a ray, in one array
hits('sphere', 'exact', [ray], objects);
// @ts-expect-error: no such answer
judge(() => 'perhaps');
