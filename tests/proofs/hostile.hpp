/* SPDX-License-Identifier: MIT */
/* Rays that come near to what is hard: rims, walls that they graze, an apex, planes that they lie
 * in; near by 2^-nearest to 2^-farthest, or not at all. */
#ifndef PROOFS_HOSTILE_HPP
#define PROOFS_HOSTILE_HPP

#include "number.hpp"

#include <random>

class hostile
{
  public:
    explicit hostile(unsigned seed) : bits(seed)
    {
    }

    double between(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(bits);
    }
    int among(int count)
    {
        return static_cast<int>(bits() % static_cast<unsigned>(count));
    }
    double power(double low, double high)
    {
        return std::exp2(between(low, high));
    }

    /* A query's numbers, INPUTS of them. */
    void query(sure_shape shape, double farthest, double nearest, double x[]);

  private:
    struct vector {
        double v[3];
    };
    std::mt19937_64 bits;

    vector along(double share, const vector &x)
    {
        return {{share * x.v[0], share * x.v[1], share * x.v[2]}};
    }
    vector sum(const vector &x, const vector &y)
    {
        return {{x.v[0] + y.v[0], x.v[1] + y.v[1], x.v[2] + y.v[2]}};
    }
    vector cross(const vector &x, const vector &y)
    {
        return {{x.v[1] * y.v[2] - x.v[2] * y.v[1], x.v[2] * y.v[0] - x.v[0] * y.v[2],
                 x.v[0] * y.v[1] - x.v[1] * y.v[0]}};
    }
    vector unit(const vector &x)
    {
        double square = x.v[0] * x.v[0] + x.v[1] * x.v[1] + x.v[2] * x.v[2];
        return along(1 / std::sqrt(square), x);
    }
    double length(const vector &x, const vector &y)
    {
        vector between = sum(x, along(-1, y));
        return std::sqrt(between.v[0] * between.v[0] + between.v[1] * between.v[1] +
                         between.v[2] * between.v[2]);
    }
    vector any()
    {
        return {{between(-1, 1), between(-1, 1), between(-1, 1)}};
    }
    /* A length that is usually a few, at times 0 or next to nothing. */
    double length()
    {
        int kind = among(8);
        return kind == 0 ? 0 : kind == 1 ? power(-44, 0) : power(-4, 4);
    }
};

inline void hostile::query(sure_shape shape, double farthest, double nearest, double x[])
{
    vector axis = unit(any()), u = unit(cross(axis, any())), v = cross(axis, u);
    double turn = between(0, 6.283), radius = power(-4, 4), height = power(-4, 4);
    if (among(4) == 0)
        (among(2) ? radius : height) *= power(-44, 0);
    vector radial = sum(along(std::cos(turn), u), along(std::sin(turn), v));
    vector around = cross(axis, radial);
    bool cone = shape_tapers(shape), solid = shape_has(shape, SURE_KIND_OTHER_POINT);
    bool flat = shape_has(shape, SURE_KIND_NORMAL);

    /* A place on the object, by its height and its distance from the axis, and a way there. */
    double level = among(3) ? among(2) : between(-0.1, 1.1), out = cone ? 1 - level : 1;
    if (among(4) == 0)
        out *= among(2) ? 0 : between(0, 1.2);
    if (!solid && !flat) {
        axis = radial; /* any direction */
        u = around;
        v = cross(axis, u);
        radial = axis;
    }
    vector foot = along(radius * out, radial), way;
    vector generator = sum(along(height, axis), along(cone ? -radius : 0, radial));
    switch (among(6)) {
    case 0: way = sum(generator, along(length() * radius, around)); break;
    case 1: way = around; break;
    case 2: way = sum(radial, along(length(), around)); break;
    case 3: way = axis; break;
    case 4: way = generator; break;
    default: way = any(); break;
    }
    way = sum(unit(way), along(among(3) ? power(-nearest, -farthest) : 0, any()));
    vector place = along(power(-3, 3) * (among(8) ? 1 : 0), any());
    vector target = sum(place, sum(foot, along(solid ? height * level : 0, axis)));
    double size = std::fmax(radius, solid ? height : 0);
    double off = among(3) ? power(-nearest, -farthest) : 0;
    vector start = sum(sum(target, along(-length() * size, way)), along(off * size, any()));
    vector d = along(power(-3, 3), way), end = sum(place, along(height, axis));
    vector n = along(power(-3, 3), axis);

    double *next = x;
    auto put = [&next](const vector &w) {
        for (double component : w.v)
            *next++ = component;
    };
    put(start);
    put(d);
    put(place);
    if (solid || flat)
        put(solid ? end : n);
    if (shape_has(shape, SURE_KIND_RADIUS))
        *next++ = radius;
    while (next != x + T_MIN)
        *next++ = 0;

    /* The range from the place on, or up to it, nearly. */
    double at = length(start, target) / length(d, {{0, 0, 0}}) + off * between(-1, 1);
    x[T_MIN] = among(2) ? 0 : std::fabs(at * (among(2) ? 1 + off * between(-1, 1) : between(0, 2)));
    x[T_MAX] = among(2) ? HUGE_VAL : x[T_MIN] + std::fabs(at * between(0, 2));
    if (among(4) == 0)
        x[T_MAX] = std::fmax(x[T_MIN], at);
}

#endif
