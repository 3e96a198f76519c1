// SPDX-License-Identifier: MIT
/* three.js. Ray: "The (normalized) direction of the ray"; no range; from inside the far side. The
 * point that it returns is measured as its Raycaster does, by distanceTo. */
import { Box3, Plane, Ray, Sphere, Vector3 } from 'three';
import { serve } from './coprocess.mjs';

const page = 'https://threejs.org/docs/#api/en/math/Ray';
const ray = new Ray(), point = new Vector3(), at = new Vector3();
const sphere = new Sphere(), plane = new Plane(), box = new Box3();

function set(r) {
    ray.origin.set(r[0], r[1], r[2]);
    ray.direction.set(r[3], r[4], r[5]);
}

const distance = (found) => found === null ? null : ray.origin.distanceTo(found);

serve({ library: 'three', entry: 'unit ray aligned', page }, {
    sphere(r, o) {
        set(r);
        sphere.center.set(o[0], o[1], o[2]);
        sphere.radius = o[3];
        return distance(ray.intersectSphere(sphere, point));
    },
    plane(r, o) {
        set(r);
        at.set(o[0], o[1], o[2]);
        plane.setFromNormalAndCoplanarPoint(point.set(o[3], o[4], o[5]), at);
        return ray.distanceToPlane(plane);
    },
    box(r, o) {
        set(r);
        box.min.set(o[0], o[1], o[2]);
        box.max.set(o[3], o[4], o[5]);
        return distance(ray.intersectBox(box, point));
    },
});
