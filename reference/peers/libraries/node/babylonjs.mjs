// SPDX-License-Identifier: MIT
/* Babylon.js. Ray: a half line; its spheres and boxes are hit or missed without t, so that no t is
 * judged. Spheres want a unit direction, which Ray.CreateNewFromTo makes. */
import { Ray } from '@babylonjs/core/Culling/ray.core.js';
import { Plane } from '@babylonjs/core/Maths/math.plane.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { serve } from './coprocess.mjs';

const vector = (from, at) => new Vector3(from[at], from[at + 1], from[at + 2]);
const rayOf = (r) => new Ray(vector(r, 0), vector(r, 3));
const hit = (found) => found ? NaN : null;

const page = 'https://doc.babylonjs.com/typedoc/classes/BABYLON.Ray';

serve({ library: '@babylonjs/core', entry: 'unit ray aligned decision', page }, {
    sphere: (r, o) => hit(rayOf(r).intersectsSphere({ center: vector(o, 0), radius: o[3] })),
    box: (r, o) => hit(rayOf(r).intersectsBoxMinMax(vector(o, 0), vector(o, 3))),
    plane(r, o) {
        const plane = Plane.FromPositionAndNormal(vector(o, 0), vector(o, 3));
        return hit(rayOf(r).intersectsPlane(plane) !== null);
    },
});
