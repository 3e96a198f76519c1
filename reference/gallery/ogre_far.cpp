// SPDX-License-Identifier: MIT
// Rays that pass a sphere of radius 1 clear of its rim, by 1 % or more, from farther and farther.
#include <OgreRay.h>
#include <OgreSphere.h>
#include <cstdio>
#include <random>
int main()
{
    std::uniform_real_distribution<float> any(-1, 1);
    for (float away = 1e2; away < 1e7; away *= 10) {
        std::mt19937 random(1);
        int wrong = 0;
        for (int asked = 0; asked < 10000;) {
            Ogre::Vector3 o{any(random), any(random), any(random)};
            Ogre::Vector3 aim{any(random), any(random), any(random)};
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
