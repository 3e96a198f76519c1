// SPDX-License-Identifier: MIT
/* Jolt. RRayCast: "direction and length of the ray": here a power of two that reaches t_max, so
 * that nothing is rounded. Static objects of 0.1 to 2000 m (Architecture, "Conventions and
 * Limits"), within 5 km ("Big Worlds"). In float, in the shape's own frame: axis y, middle 0. */
import initJolt from 'jolt-physics';
import { serve } from './coprocess.mjs';

const entry = 'float unit segment centred scale=0.1..2000';
const Jolt = await initJolt();
const ray = new Jolt.RRayCast(), settings = new Jolt.RayCastSettings();
const closest = new Jolt.CastRayClosestHitCollisionCollector(), all = new Jolt.ShapeFilter();
const placed = new Jolt.TransformedShape(), half = new Jolt.Vec3();
const origin = new Jolt.RVec3(0, 0, 0), whole = new Jolt.Vec3(1, 1, 1);
const upright = new Jolt.Quat(0, 0, 0, 1);
settings.mTreatConvexAsSolid = false;
settings.SetBackFaceMode(Jolt.EBackFaceMode_CollideWithBackFaces);

/* z becomes y. The shape that was placed before is freed. */
function cast(r, shape) {
    const reach = 2 ** Math.max(-14, Math.min(14, Math.ceil(Math.log2(r[7]))));
    placed.mShape = shape;
    placed.SetWorldTransform(origin, upright, whole);
    ray.mOrigin.Set(r[1], r[2], r[0]);
    ray.mDirection.Set(reach * r[4], reach * r[5], reach * r[3]);
    closest.Reset();
    placed.CastRay(ray, settings, closest, all);
    const t = reach * closest.mHit.mFraction;
    return closest.HadHit() && t <= r[7] ? t : null;
}

serve({ library: 'jolt-physics', entry, page: 'https://jrouwe.github.io/JoltPhysics/' }, {
    sphere: (r, o) => cast(r, new Jolt.SphereShape(o[3])),
    cylinder: (r, o) => cast(r, new Jolt.CylinderShape(o[5], o[6], 0)),
    cone(r, o) {
        const made = new Jolt.TaperedCylinderShapeSettings(o[5], 0, o[6], 0);
        const t = cast(r, made.Create().Get());
        Jolt.destroy(made);
        return t;
    },
    box: (r, o) => cast(r, (half.Set(o[4], o[5], o[3]), new Jolt.BoxShape(half, 0))),
});
