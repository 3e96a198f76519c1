// SPDX-License-Identifier: MIT
// Rays at the centre of a ball of radius 1, from farther and farther.
const RAPIER = require('@dimforge/rapier3d-compat');
RAPIER.init({}).then(() => {
    const ball = new RAPIER.Ball(1);
    const centre = { x: 0, y: 0, z: 0 }, unturned = { x: 0, y: 0, z: 0, w: 1 };
    for (const away of [1e2, 1e3, 1e4, 1e5]) {
        let missed = 0;
        for (let i = 0; i < 10000; i++) {
            const start = [i - 5000, 3000, i % 100].map((step) => step * away / 5000);
            const [x, y, z] = start.map(Math.fround);
            const far = Math.sqrt(x * x + y * y + z * z);
            const ray = new RAPIER.Ray({ x, y, z }, { x: -x / far, y: -y / far, z: -z / far });
            missed += ball.castRay(ray, centre, unturned, 2 * far, true) < 0;
        }
        console.log(`${away} radii: expected 0 of 10000 missed, got ${missed}`);
    }
});
