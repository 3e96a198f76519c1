/* SPDX-License-Identifier: MIT */
/* What a shape tells the reference: a row of functions, in cgal_<shape>.cpp. What the routes to one
 * answer need stands in different functions, and none of them calls another's. */
#ifndef REFERENCE_CGAL_SHAPE_H
#define REFERENCE_CGAL_SHAPE_H

#include <memory>
#include <optional>
#include <vector>

#include "cgal_kernel.h"
#include "cgal_line.h"

namespace exact {

/* A point in exact numbers. */
using point = std::array<surd, 3>;

/* What CGAL's linear kernel says that a line has in common with an object: the whole line, points,
 * or what it has in common with a sphere. */
struct common_points {
    struct ball {
        kernel::Point_3 centre;
        rational squared_radius;
    };
    bool whole_line;
    std::vector<kernel::Point_3> points;
    std::optional<ball> sphere;
};

/* An object's numbers whatever its shape; far_end is where the axis leads, normal is zero where
 * there is none. */
struct fields {
    sure_vec3 anchor, far_end, normal;
    double radius;
};

/* An object in integers: `axis` leads from the anchor to the far end or is the normal. */
struct frame {
    line on;
    vector anchor, axis;
    integer radius;
};

struct shape_row {
    /* The first invalid field. The functions below are asked of valid objects. */
    sure_field (*check)(const sure_object &object);

    /* The answers (cgal_reference.cpp). */
    std::unique_ptr<question> (*ask)(const sure_ray &ray, const sure_object &object);

    /* By CGAL's linear kernel (cgal_where.cpp): reference_where for any rational point. */
    int (*where)(const sure_object &object, const kernel::Point_3 &p);
    /* The object is what all its layers and the inside of its surface have in common. */
    std::vector<layer> (*layers)(const sure_object &object);
    /* Positive outside the curved surface continued without end, zero on it, negative inside: the
     * squared distance from centre or axis less the squared radius there. Null where there is
     * none. */
    rational (*surface)(const sure_object &object, const kernel::Point_3 &p);

    /* By CGAL's own intersections (cgal_kernel.cpp); null where it has none. */
    common_points (*meet)(const sure_object &object, const kernel::Line_3 &line);

    /* By the definition (cgal_certify.cpp), q / w away from the anchor: -1 inside, 0 on the
     * boundary, 1 outside; and at a boundary point the way out, of any length. */
    fields (*fields_of)(const sure_object &object);
    int (*side)(const frame &object, const point &q, const integer &w);
    point (*way_out)(const frame &object, const point &q, const integer &w);

    /* reference_wall_normal and reference_height; null where there is no wall. */
    sure_vec3 (*wall_normal)(const sure_object &object, const sure_vec3 &p);
    bool (*height)(const sure_object &object, const sure_vec3 &p);
};

/* The table. A number that is no shape ends the program. */
const shape_row &row_of(const sure_object &object);

bool finite(const sure_vec3 &v);
bool equal(const sure_vec3 &u, const sure_vec3 &v);
bool is_zero(const sure_vec3 &v);

/* The first invalid one of fields in the contract's order. */
sure_field check_facing(const sure_vec3 &point, sure_field point_field, const sure_vec3 &normal);
sure_field check_ends(const sure_vec3 &base, const sure_vec3 &end, sure_field end_field);
sure_field check_radius(sure_field earlier, double radius);

/* where for the solids that are a wall between two planes. */
int where_capped(const sure_object &object, const kernel::Point_3 &p);

surd dot(const vector &u, const point &v);
surd square(const point &v);
surd square_of_cross(const vector &u, const point &v);
point times(const vector &v, const surd &factor);
point times(const integer &factor, const point &v);
point minus(const point &u, const point &v);
inline int sign(const surd &x) { return x.sign(); }

/* Outside (1), on (0) or between (-1) the planes through the axis' ends, A.q / w being `along`. */
int side_of_ends(const frame &object, const surd &along, const integer &w);

/* A wall's object in integers: q leads from base or apex to the point, axis to the other end. */
struct wall_frame {
    wall_frame(const sure_vec3 &from, const sure_vec3 &to, double radius, const sure_vec3 &p);

    vector q, axis;
    integer radius;
};

sure_vec3 nearest_vector(const unit_vector &v);

}

#endif
