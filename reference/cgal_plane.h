/* SPDX-License-Identifier: MIT */
/* Plane and disc. For P = o + tau d, m = o - Q:
 *
 *     N.(P - Q) = N.m + tau N.d = 0     =>  tau = -N.m / N.d           (not parallel)
 *
 * and a parallel line lies in the plane when N.m = 0. Second derivation, by another point: with
 * foot F = o - (N.m / N.N) N of o on the plane, o F = -(N.m / N.N) N, and the part of tau d along
 * N, tau (N.d / N.N) N, must make up for it: the same tau. */
#ifndef REFERENCE_CGAL_PLANE_H
#define REFERENCE_CGAL_PLANE_H

#include "cgal_shape.h"

namespace exact {

class plane_question : public question {
public:
    plane_question(const line &on, const vector &point, const vector &normal)
        : question(on), normal_(normal), height_(dot(normal, on.origin - point)),
          slope_(dot(normal, on.direction))
    {
    }

    span chord() const override
    {
        if (slope_.sign() != 0)
            return between(crossing(), crossing(), false);
        return height_.sign() == 0 ? everything(false) : nothing();
    }

    sure_part part(const real &) const override { return SURE_PART_SURFACE; }

    unit_vector normal(const real &) const override { return unit(normal_); }

    reference_decisions decisions() const override
    {
        reference_decisions signs = no_decisions();
        signs.axis = slope_.sign();
        return signs;
    }

protected:
    real crossing() const { return on_.at(surd(-height_), slope_); }

    vector normal_;
    integer height_, slope_;
};

inline point way_out_of_plane(const frame &object, const point &, const integer &)
{
    return times(object.axis, surd(1));
}

}

#endif
