/* SPDX-License-Identifier: MIT */
/* VTK, the Visualization Toolkit: vtkPlane and vtkBox::IntersectWithLine
 * (https://vtk.org/doc/release/9.1/html/classvtkPlane.html, .../classvtkBox.html).
 *
 *     segment        "a line defined by the two points p1, p2": t is "the parametric coordinate"
 *     unit, aligned  so that p2 is another point, and a plane's normal has length 1
 *     scale          squares of lengths neither overflow nor underflow */
#include "library.h"

#include <vtkBox.h>
#include <vtkPlane.h>

const char sure_candidate_entry[] = "unit aligned segment scale=1e-3..1e6";

/* Where the ray is at t. */
struct point {
    double at[3];
    point(const double *ray, double t)
    {
        for (int i = 0; i < 3; i++)
            at[i] = ray[i] + t * ray[3 + i];
    }
};

int sure_candidate_plane(const double *ray, const double *plane, peer_hit *hit)
{
    double p0[] = {plane[0], plane[1], plane[2]}, n[] = {plane[3], plane[4], plane[5]}, t, x[3];
    bool meets = vtkPlane::IntersectWithLine(ray, point(ray, ray[7]).at, n, p0, t, x);
    return found_at(ray, meets ? t * ray[7] : NAN, hit);
}

int sure_candidate_box(const double *ray, const double *box, peer_hit *hit)
{
    const double bounds[] = {box[0], box[3], box[1], box[4], box[2], box[5]};
    double t1, t2, x1[3], x2[3];
    int in, out;
    bool meets =
        vtkBox::IntersectWithLine(bounds, ray, point(ray, ray[7]).at, t1, t2, x1, x2, in, out);
    double t = in >= 0 ? t1 : out >= 0 ? t2 : NAN;
    return found_at(ray, meets ? t * ray[7] : NAN, hit);
}
