// SPDX-License-Identifier: MIT
/* Rapier. castRay: any direction, maxToi "limits the length of the ray to ray.dir.norm() *
 * maxToi", `solid` false: "all shapes are hollow for this ray-cast", from inside the far side is
 * met. In float, in the shape's own frame: its axis is y, its middle the origin. */
import RAPIER from '@dimforge/rapier3d-compat';
import { serve } from './coprocess.mjs';

await RAPIER.init({});

const page = 'https://rapier.rs/docs/user_guides/javascript/scene_queries_ray_casting';
const entry = 'float t_min=0 centred scale=0.001..1e6';
const origin = { x: 0, y: 0, z: 0 }, unturned = { x: 0, y: 0, z: 0, w: 1 };

/* z becomes y. */
function cast(r, shape) {
    const ray = new RAPIER.Ray({ x: r[1], y: r[2], z: r[0] }, { x: r[4], y: r[5], z: r[3] });
    const t = shape.castRay(ray, origin, unturned, r[7], false);
    return t < 0 || t === undefined || !(t <= r[7]) ? null : t;
}

serve({ library: '@dimforge/rapier3d-compat', entry, page }, {
    sphere: (r, o) => cast(r, new RAPIER.Ball(o[3])),
    plane: (r) => cast(r, new RAPIER.HalfSpace({ x: 0, y: 1, z: 0 })),
    cylinder: (r, o) => cast(r, new RAPIER.Cylinder(o[5], o[6])),
    cone: (r, o) => cast(r, new RAPIER.Cone(o[5], o[6])),
    box: (r, o) => cast(r, new RAPIER.Cuboid(o[4], o[5], o[3])),
});
