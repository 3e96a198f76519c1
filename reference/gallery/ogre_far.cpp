// SPDX-License-Identifier: MIT
// Rays that pass a sphere of radius 1 clear of its rim, by 1 % or more, from farther and farther.
#include <OgreRay.h>
#include <OgreSphere.h>
#include <cstdio>
int main()
{
    for (float away = 1e2; away < 1e7; away *= 10) {
        int asked = 0, wrong = 0;
        for (int i = 0; asked < 10000; i++) {
            Ogre::Vector3 o(sin(i), cos(i), cos(3 * i)), aim(cos(5 * i), sin(7 * i), cos(11 * i));
            o *= away / o.length();
            Ogre::Ray ray(o, (aim - o).normalisedCopy());
            Ogre::Vector<3, double> p(o), d(ray.getDirection());
            double off = (p - p.dotProduct(d) / d.dotProduct(d) * d).length();
            if (std::abs(off - 1) > 0.01 && ++asked)
                wrong += ray.intersects(Ogre::Sphere(Ogre::Vector3::ZERO, 1)).first != (off < 1);
        }
        printf("%.0e radii away: expected 0 of 10000 wrong, got %d\n", away, wrong);
    }
}
