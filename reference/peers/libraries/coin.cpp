/* SPDX-License-Identifier: MIT */
/* Coin, Open Inventor's scene graph: SoRayPickAction of a shape
 * (https://www.coin3d.org/coin/classSoRayPickAction.html, .../classSoCylinder.html).
 *
 *     unit      t is told from the point that is picked
 *     centred   shapes have their middle in the origin, their axis is y
 *     ray       from the near plane, which is the start, on
 *     scale     squares of lengths neither overflow nor underflow */
#include "library.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/nodes/SoNodes.h>

const char sure_candidate_entry[] = "unit centred ray scale=1e-3..1e6";

static const bool started = (SoDB::init(), true);
struct node {
    std::shared_ptr<SoNode> of;
    int meet(const real *ray, peer_hit *hit) const
    {
        static SoRayPickAction action{SbViewportRegion()};
        const SbVec3f from(ray[1], ray[2], ray[0]), way(ray[4], ray[5], ray[3]);
        action.setRay(from, way, 0);
        action.apply(of.get());
        const SoPickedPoint *first = action.getPickedPoint();
        return found_at(ray, first ? (first->getPoint() - from).dot(way) : NAN, hit);
    }
};
static node with(SoNode *made, const char *fields, real radius, real height = 0)
{
    char text[80];
    std::snprintf(text, sizeof text, fields, radius, height);
    made->ref();
    made->set(text);
    return {{made, [](SoNode *gone) { gone->unref(); }}};
}
ANSWER_BY(sphere, node, with(new SoSphere, "radius %.9g", n[3]))
ANSWER_BY(cylinder, node, with(new SoCylinder, "radius %.9g height %.9g", n[6], 2 * n[5]))
ANSWER_BY(cone, node, with(new SoCone, "bottomRadius %.9g height %.9g", n[6], 2 * n[5]))
