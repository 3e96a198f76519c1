/* SPDX-License-Identifier: MIT */
/* Bounds and decisions of the first stages, and what roundings may do to them. */
#ifndef PROOFS_CLAIMS_HPP
#define PROOFS_CLAIMS_HPP

#define WITH_PAIRS
#include "tape.hpp"

static const double ROUNDING = 0x1p-52;

/* Without a rounding of its own. */
static scalar exactly(scalar x)
{
    tape[static_cast<size_t>(x.step)].rounded = 0;
    return x;
}

/* What the result may be off by. */
static double worst(scalar result)
{
    static std::vector<double> by;
    double all = 0;
    by.assign(tape.size(), 0);
    by[static_cast<size_t>(result.step)] = 1;
    for (size_t i = static_cast<size_t>(result.step); i > 0; i--) {
        const step &at = tape[i];
        all += fabs(by[i] * at.rounded);
        by[static_cast<size_t>(at.x)] += by[i] * at.by_x;
        by[static_cast<size_t>(at.y)] += by[i] * at.by_y;
    }
    return all * ROUNDING;
}

/* x op y: the tail makes up for the head's rounding, and has none. */
static double_pair error_free(operation what, scalar x, scalar y, double exact, double tail)
{
    scalar head = computed(what, x, y, exact), both = exactly(computed(what, x, y, exact));
    return {head, exactly(computed(DIFFERENCE, both, head, tail))};
}

double_pair exact_sum(scalar x, scalar y)
{
    double head = x.value + y.value, of_y = head - x.value;
    return error_free(SUM, x, y, head, (x.value - (head - of_y)) + (y.value - of_y));
}

double_pair exact_product(scalar x, scalar y)
{
    double head = x.value * y.value;
    return error_free(PRODUCT, x, y, head, fma(x.value, y.value, -head));
}

/* What a claim is about, recorded. */
struct case_of {
    query q;
    filter_verdict verdict;
    filter_interval found;
};

static const double NOTHING = -1; /* nothing is claimed there */

static double share(scalar result, double bound)
{
    double share = worst(result) / bound;
    return share >= 0 ? share : NOTHING;
}

/* Of a number's sign that was claimed. */
static double sign(scalar x)
{
    return x.step > 0 ? share(x, fabs(x.value)) : NOTHING;
}

static flat_terms flat_of(const case_of &c)
{
    const sure_plane &plane = c.q.object.as.plane;
    return flat_terms_of(&c.q.ray, &plane.point, &plane.normal);
}

static double crossing_t(const case_of &c)
{
    return c.verdict == FILTER_INTERVAL ? share(c.found.enter.t, c.found.enter.error.value)
                                        : NOTHING;
}

static double crossing_behind(const case_of &c)
{
    flat_terms of = flat_of(c);
    double most = of.lift.value + c.q.ray.t_min.value * of.steepest.value;
    return share(flat_late(&of, c.q.ray.t_min), SURE_CROSSING_BEHIND_BOUND * most);
}

/* A crossing before t_min: the signs of both, (t_min - t) e and e, were claimed. */
static double behind(const case_of &c)
{
    flat_terms of = flat_of(c);
    if (c.verdict != FILTER_MISS)
        return NOTHING;
    return fmax(sign(flat_late(&of, c.q.ray.t_min)), sign(of.e));
}

static double crossing_sign(const case_of &c)
{
    flat_terms of = flat_of(c);
    return share(of.e, SURE_CROSSING_SIGN_BOUND * of.steepest.value);
}

/* Which end of a box's chord comes first was claimed. */
static double box_order(const case_of &c)
{
    box_terms of = box_terms_of(&c.q.ray, &c.q.object.as.box);
    scalar before, enter = box_last(of.x.near, of.y.near, of.z.near, &before);
    scalar leave = box_last(-of.x.far, -of.y.far, -of.z.far, &before);
    if (c.verdict == FILTER_UNCERTAIN)
        return NOTHING;
    return sign(exactly(enter + leave));
}

static disc_foot_terms foot_of(const case_of &c, scalar *beyond)
{
    flat_terms of = flat_of(c);
    disc_foot_terms foot = disc_foot_terms_of(&of, &c.q.ray, c.q.object.as.disc.radius);
    *beyond = exactly(exactly(sqrt(foot.square)) - foot.rim);
    return foot;
}

static double disc_foot(const case_of &c)
{
    scalar beyond;
    disc_foot_terms foot = foot_of(c, &beyond);
    bool near = fabs(beyond.value) < 0.5 * foot.rim.value;
    return near ? share(beyond, foot.slack.value) : NOTHING;
}

static double disc_outside(const case_of &c)
{
    scalar beyond;
    foot_of(c, &beyond);
    flat_terms of = flat_of(c);
    return c.verdict == FILTER_MISS && !flat_behind(&of, c.q.ray.t_min) ? sign(beyond) : NOTHING;
}

static double disc_inside(const case_of &c)
{
    scalar beyond;
    foot_of(c, &beyond);
    return c.verdict == FILTER_INTERVAL ? sign(beyond) : NOTHING;
}

static sphere_terms sphere_of(const case_of &c)
{
    return sphere_terms_of(&c.q.ray, &c.q.object.as.sphere);
}

static bool is_plain(const sphere_terms &of)
{
    return of.discriminant.value > SURE_SPHERE_CERTAIN * of.a.value * of.size.value;
}

static double sphere_discriminant(const case_of &c)
{
    sphere_terms of = sphere_of(c);
    return share(of.discriminant, SURE_SPHERE_DISCRIMINANT_BOUND * of.a.value * of.size.value);
}

static double sphere_t(const case_of &c)
{
    if (c.verdict != FILTER_INTERVAL || !is_plain(sphere_of(c)))
        return NOTHING;
    return share(c.found.enter.t, c.found.enter.error.value);
}

static double sphere_close(const case_of &c)
{
    sphere_terms of = sphere_of(c);
    sphere_close_terms close = sphere_close_terms_of(&of, c.q.object.as.sphere.radius);
    double off = SURE_SPHERE_CLOSE_BOUND * sqrt(close.sum.value) * close.all.value;
    return fabs(close.discriminant.value) > off ? share(close.discriminant, off) : NOTHING;
}

static double sphere_close_t(const case_of &c)
{
    if (c.verdict != FILTER_INTERVAL || is_plain(sphere_of(c)))
        return NOTHING;
    return share(c.found.leave.t, c.found.leave.error.value);
}

static double sphere_miss(const case_of &c)
{
    sphere_terms of = sphere_of(c);
    sphere_close_terms close = sphere_close_terms_of(&of, c.q.object.as.sphere.radius);
    if (c.verdict != FILTER_MISS)
        return NOTHING;
    return fmin(sign(of.discriminant), sign(close.discriminant));
}

/* The discriminant of cylinder or cone, where its square is beyond what makes its sign certain, and
 * where it said that the wall is missed. */
#define WALL(shape)                                                                                \
    static double shape##_discriminant(const case_of &c)                                           \
    {                                                                                              \
        axial_terms of = shape##_terms_of(&c.q.ray, &c.q.object.as.shape);                         \
        scalar d = of.inner - of.outer;                                                            \
        double certain = of.certain.value;                                                         \
        return d.value * d.value > certain ? share(d, sqrt(certain)) : NOTHING;                    \
    }                                                                                              \
    static double missed_##shape(const case_of &c)                                                 \
    {                                                                                              \
        axial_terms of = shape##_terms_of(&c.q.ray, &c.q.object.as.shape);                         \
        scalar d = of.inner - of.outer;                                                            \
        return c.verdict == FILTER_MISS && d.value < 0 ? sign(d) : NOTHING;                        \
    }
WALL(cylinder)
WALL(cone)

static double ends(const case_of &c, bool wall)
{
    double most = NOTHING;
    if (c.verdict == FILTER_INTERVAL)
        for (const filter_end &end : {c.found.enter, c.found.leave})
            if ((end.end.part == SURE_PART_WALL) == wall)
                most = fmax(most, share(end.t, end.error.value));
    return most;
}

static double wall(const case_of &c)
{
    return ends(c, true);
}
static double plane(const case_of &c)
{
    return ends(c, false);
}

/* The cone's leading coefficient, which is what 1 is divided by first, and A.d. */
static double leading(const case_of &c)
{
    return c.verdict == FILTER_MISS && !inverted.empty() ? sign(inverted[0]) : NOTHING;
}

static double leading_of_chord(const case_of &c)
{
    return c.verdict == FILTER_INTERVAL ? sign(inverted[0]) : NOTHING;
}

static double slope_of_chord(const case_of &c)
{
    return plane(c) >= 0 ? sign(inverted[1]) : NOTHING;
}

static double length(double x, double y, double z)
{
    return sqrt(x * x + y * y + z * z);
}

/* The error over the contract's limit; all fields begin with the place that it is measured from. */
static double limit(const case_of &c)
{
    const sure_ray &ray = c.q.ray;
    const sure_shape_info *info = sure_shape_info_of(c.q.object.shape);
    const scalar *numbers = reinterpret_cast<const scalar *>(&c.q.object.as);
    auto vector_at = [numbers](int at) {
        return sure_vec3{numbers[at], numbers[at + 1], numbers[at + 2]};
    };
    auto between = [](const sure_vec3 &x, const sure_vec3 &y) {
        return length(x.x.value - y.x.value, x.y.value - y.y.value, x.z.value - y.z.value);
    };
    double size = 0;
    for (int i = 1; i < info->field_count; i++) {
        const sure_shape_field &field = info->fields[i];
        if (field.kind == SURE_KIND_RADIUS)
            size += numbers[field.at].value;
        else if (field.kind != SURE_KIND_NORMAL)
            size += between(vector_at(0), vector_at(field.at));
    }
    if (c.verdict != FILTER_INTERVAL)
        return NOTHING;
    double error = fmax(c.found.enter.error.value, c.found.leave.error.value);
    double d = between(ray.direction, sure_vec3{0.0, 0.0, 0.0});
    return error * d / (SURE_T_ERROR_CAP * (between(ray.origin, vector_at(0)) + size));
}

/* Of a step of the polish, from a t that is off by up to this of itself; roundings are to nearest
 * there, half of what they are elsewhere. */
static double step_from(const case_of &c, double off, bool wall)
{
    const sure_object &object = c.q.object;
    const filter_end &from = c.found.enter;
    bool on_wall = from.end.part == SURE_PART_WALL || from.end.part == SURE_PART_SURFACE;
    if (c.verdict != FILTER_INTERVAL || on_wall != wall)
        return NOTHING;
    scalar t =
        put({GIVEN, 0, 0, 0, 0, 0, 0, 0}, from.t.value + off * c.q.ray.t_min.value * from.t.value);
    polish_step way{};
    switch (object.shape) {
#define STEP(shape, SHAPE)                                                                         \
    case SURE_SHAPE_##SHAPE: way = shape##_step(&c.q.ray, &object.as, from.end, t); break;
        SURE_EACH_SHAPE(STEP)
#undef STEP
    }
    return way.certain ? 0.5 * share(way.step, way.error.value) : NOTHING;
}

static double wall_step(const case_of &c)
{
    return step_from(c, 0x1p-12, true);
}

static double wall_residual(const case_of &c)
{
    return step_from(c, 0x1p-58, true);
}

static double plane_step(const case_of &c)
{
    return step_from(c, 0x1p-12, false);
}

static double plane_residual(const case_of &c)
{
    return step_from(c, 0x1p-58, false);
}

/* What is shown, of which it must be more than `least`. */
struct claim {
    const char *name;
    sure_shape shape;
    double (*share)(const case_of &);
    double least;
};

static const claim CLAIMS[] = {
    {"SURE_CROSSING_T_BOUND", SURE_SHAPE_PLANE, crossing_t, 0.1},
    {"SURE_CROSSING_BEHIND_BOUND", SURE_SHAPE_PLANE, crossing_behind, 0.1},
    {"SURE_CROSSING_SIGN_BOUND", SURE_SHAPE_PLANE, crossing_sign, 0.1},
    {"BOX_SHARE", SURE_SHAPE_BOX, crossing_t, 0.1},
    {"SURE_DISC_FOOT_BOUND", SURE_SHAPE_DISC, disc_foot, 0.1},
    {"SURE_SPHERE_DISCRIMINANT_BOUND", SURE_SHAPE_SPHERE, sphere_discriminant, 0.1},
    {"SURE_SPHERE_T_BOUND", SURE_SHAPE_SPHERE, sphere_t, 0.1},
    {"SURE_SPHERE_CLOSE_BOUND", SURE_SHAPE_SPHERE, sphere_close, 0.1},
    {"SURE_SPHERE_CLOSE_T_BOUND", SURE_SHAPE_SPHERE, sphere_close_t, 0.1},
    {"SURE_CYLINDER_DISCRIMINANT_BOUND", SURE_SHAPE_CYLINDER, cylinder_discriminant, 0.1},
    {"SURE_CYLINDER_WALL_BOUND", SURE_SHAPE_CYLINDER, wall, 0.1},
    {"SURE_AXIAL_PLANE_BOUND, cylinder", SURE_SHAPE_CYLINDER, plane, 0.1},
    {"SURE_CONE_DISCRIMINANT_BOUND", SURE_SHAPE_CONE, cone_discriminant, 0.1},
    {"SURE_CONE_LEADING_BOUND", SURE_SHAPE_CONE, leading, 0.1},
    {"SURE_CONE_WALL_BOUND", SURE_SHAPE_CONE, wall, 0.1},
    {"SURE_AXIAL_PLANE_BOUND, cone", SURE_SHAPE_CONE, plane, 0.1},
    {"SURE_CROSSING_STEP_BOUND", SURE_SHAPE_PLANE, wall_step, 0.1},
    {"SURE_CROSSING_RESIDUAL_BOUND", SURE_SHAPE_PLANE, wall_residual, 0.1},
    {"SURE_SPHERE_STEP_BOUND", SURE_SHAPE_SPHERE, wall_step, 0.1},
    {"SURE_SPHERE_RESIDUAL_BOUND", SURE_SHAPE_SPHERE, wall_residual, 0.1},
    {"SURE_AXIAL_STEP_BOUND, cylinder", SURE_SHAPE_CYLINDER, wall_step, 0.02},
    {"SURE_AXIAL_RESIDUAL_BOUND, cylinder", SURE_SHAPE_CYLINDER, wall_residual, 0.02},
    {"SURE_AXIAL_STEP_BOUND, cone", SURE_SHAPE_CONE, wall_step, 0.02},
    {"SURE_AXIAL_RESIDUAL_BOUND, cone", SURE_SHAPE_CONE, wall_residual, 0.02},
    {"SURE_AXIAL_PLANE_STEP_BOUND", SURE_SHAPE_CYLINDER, plane_step, 0.1},
    {"SURE_AXIAL_PLANE_RESIDUAL_BOUND", SURE_SHAPE_CYLINDER, plane_residual, 0.1},
    {"crossing before t_min", SURE_SHAPE_PLANE, behind, 0},
    {"ends of a box", SURE_SHAPE_BOX, box_order, 0},
    {"disc missed outside", SURE_SHAPE_DISC, disc_outside, 0},
    {"disc met inside", SURE_SHAPE_DISC, disc_inside, 0},
    {"sphere missed", SURE_SHAPE_SPHERE, sphere_miss, 0},
    {"cylinder's wall missed", SURE_SHAPE_CYLINDER, missed_cylinder, 0},
    {"cone's wall missed", SURE_SHAPE_CONE, missed_cone, 0},
    {"leading coefficient of a chord", SURE_SHAPE_CONE, leading_of_chord, 0},
    {"A.d of a cylinder's chord", SURE_SHAPE_CYLINDER, slope_of_chord, 0},
    {"A.d of a cone's chord", SURE_SHAPE_CONE, slope_of_chord, 0},
    {"limit of a plane", SURE_SHAPE_PLANE, limit, 0},
    {"limit of a disc", SURE_SHAPE_DISC, limit, 0},
    {"limit of a box", SURE_SHAPE_BOX, limit, 0},
    {"limit of a sphere", SURE_SHAPE_SPHERE, limit, 0},
    {"limit of a cylinder", SURE_SHAPE_CYLINDER, limit, 0},
    {"limit of a cone", SURE_SHAPE_CONE, limit, 0},
};

#endif
