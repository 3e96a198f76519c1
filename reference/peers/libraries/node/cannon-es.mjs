// SPDX-License-Identifier: MIT
/* cannon-es. Ray: "from" a point "to" another, so the range ends, at o + t_max d as rounded. Its
 * plane goes through its body's position, across +z; its cylinder is a polyhedron. */
import { Body, Plane, Ray, RaycastResult, Sphere, Vec3 } from 'cannon-es';
import { serve } from './coprocess.mjs';

const page = 'https://pmndrs.github.io/cannon-es/docs/classes/Ray.html';
const ray = new Ray(new Vec3(), new Vec3());
const result = new RaycastResult();
ray.mode = Ray.CLOSEST;

function cast(r, shape, x, y, z) {
    const body = new Body({ shape, position: new Vec3(x, y, z) });
    ray.from.set(r[0], r[1], r[2]);
    ray.to.set(r[0] + r[7] * r[3], r[1] + r[7] * r[4], r[2] + r[7] * r[5]);
    result.reset();
    ray.intersectBody(body, result);
    return result.hasHit ? result.distance : null;
}

serve({ library: 'cannon-es', entry: 'unit segment aligned', page }, {
    sphere: (r, o) => cast(r, new Sphere(o[3]), o[0], o[1], o[2]),
    plane: (r, o) => cast(r, new Plane(), o[0], o[1], o[2]),
});
