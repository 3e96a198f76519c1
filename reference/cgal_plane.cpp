/* Plane and disc. For P = o + tau d, m = o - Q:
 *
 *     N.(P - Q) = N.m + tau N.d = 0     =>  tau = -N.m / N.d           (not parallel)
 *
 * and a parallel line lies in the plane when N.m = 0. Second derivation, by another point: with
 * foot F = o - (N.m / N.N) N of o on the plane, o F = -(N.m / N.N) N, and the part of tau d along
 * N, tau (N.d / N.N) N, must make up for it: the same tau.
 *
 * A disc keeps the tau with |m + tau d|^2 <= r^2; on a line in its plane that is the sphere's
 * quadratic (cgal_sphere.cpp). The whole chord belongs to the set, so none of it is interior. */
#include "cgal_line.h"

namespace exact {

namespace {

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

class disc_question : public plane_question {
public:
    disc_question(const line &on, const vector &centre, const vector &normal, const integer &radius)
        : plane_question(on, centre, normal), m_(on.origin - centre), radius_(radius),
          circle_(sphere_quadratic(m_, on.direction, radius))
    {
    }

    span chord() const override
    {
        if (slope_.sign() != 0)
            return cap() <= 0 ? between(crossing(), crossing(), false) : nothing();
        if (height_.sign() != 0 || circle_.discriminant() < 0)
            return nothing();
        return between(circle_.low_root(on_), circle_.high_root(on_), false);
    }

    reference_decisions decisions() const override
    {
        reference_decisions signs = plane_question::decisions();
        if (signs.axis != 0)
            signs.base_cap = cap();
        else
            signs.discriminant = circle_.discriminant();
        return signs;
    }

private:
    int cap() const { return distance_sign(m_, on_.direction, radius_, crossing()); }

    vector m_;
    integer radius_;
    quadratic circle_;
};

vector count_alone(const sure_vec3 &v)
{
    return common_unit().show(v).count(v);
}

}

std::unique_ptr<question> ask_plane(const sure_ray &ray, const sure_plane &plane)
{
    common_unit length;
    length.show(ray.origin).show(plane.point);
    return std::make_unique<plane_question>(make_line(ray, length), length.count(plane.point),
                                            count_alone(plane.normal));
}

std::unique_ptr<question> ask_disc(const sure_ray &ray, const sure_disc &disc)
{
    common_unit length;
    length.show(ray.origin).show(disc.centre).show(disc.radius);
    return std::make_unique<disc_question>(make_line(ray, length), length.count(disc.centre),
                                           count_alone(disc.normal), length.count(disc.radius));
}

}
