/* SPDX-License-Identifier: MIT */
/* Box. */
#include "../test_shape.h"

#include "../../../src/geometry/coordinate.h"

/* The low faces are the same. */
static sure_object companion(const sure_ray *ray, const sure_object *object)
{
    const sure_box *s = &object->as.box;
    (void)ray;
    return object_made(SURE_SHAPE_BOX, s->low, s->low, vector_sum(2, s->high, -1, s->low), 0);
}

static true_frame frame(const sure_object *object)
{
    const sure_box *s = &object->as.box;
    return (true_frame){.from = s->low, .back = s->low, .to = s->high};
}

typedef struct {
    sure_part part;
    bool crossed, beside;
    mpfr_t t;
} true_face;

/* Where the line crosses the plane of a face, or is in it. */
static void set_face(true_face *f, const true_line *line, int face)
{
    const sure_ray *ray = &line->of.ray;
    const sure_box *box = &line->of.object.as.box;
    const double corner = coordinate(face % 2 == 0 ? box->low : box->high, face / 2);
    const double o = coordinate(ray->origin, face / 2), d = coordinate(ray->direction, face / 2);
    mpfr_init2(f->t, line->bits);
    mpfr_set_d(f->t, corner, MPFR_RNDN);
    mpfr_sub_d(f->t, f->t, o, MPFR_RNDN);
    f->part = (sure_part)(SURE_PART_X_MIN + face);
    f->crossed = d != 0;
    f->beside = !f->crossed && mpfr_sgn(f->t) * (face % 2 == 0 ? 1 : -1) > 0;
    if (f->crossed)
        mpfr_div_d(f->t, f->t, d, MPFR_RNDN);
}

/* Is the line's point at t on that face, if it is in the box? */
static bool is_on(const true_face *f, mpfr_t t)
{
    return f->crossed ? mpfr_equal_p(f->t, t) != 0 : mpfr_zero_p(f->t) != 0;
}

static sure_part part_at(const true_face faces[6], mpfr_t t)
{
    for (int i = 0; i < 6; i++) {
        if (is_on(&faces[i], t))
            return faces[i].part;
    }
    return SURE_PART_SURFACE;
}

/* Nearer to a bound of the interval than another, where the line comes in (0) or goes out (1). */
static void narrow(true_line *line, const true_face *near, const true_face *far)
{
    if (mpfr_greater_p(near->t, line->t[0]))
        mpfr_set(line->t[0], near->t, MPFR_RNDN);
    if (mpfr_less_p(far->t, line->t[1]))
        mpfr_set(line->t[1], far->t, MPFR_RNDN);
}

static bool in_box(true_line *line)
{
    true_face faces[6];
    bool beside = false, flat = false;
    mpfr_set_inf(line->t[0], -1);
    mpfr_set_inf(line->t[1], 1);
    line->at[0] = TRUE_BASE;
    line->at[1] = TRUE_TOP;
    for (int i = 0; i < 6; i++) {
        set_face(&faces[i], line, i);
        beside = beside || faces[i].beside;
        flat = flat || (!faces[i].crossed && mpfr_zero_p(faces[i].t));
    }
    for (int i = 0; i < 3; i++) {
        if (coordinate(line->of.ray.direction, i) != 0)
            narrow(line, &faces[2 * i + (coordinate(line->of.ray.direction, i) < 0)],
                   &faces[2 * i + (coordinate(line->of.ray.direction, i) > 0)]);
    }
    for (int i = 0; i < 2; i++)
        line->part[i] = part_at(faces, line->t[i]);
    TRUE_NUMBERS(line->bits, nowhere);
    line->part[2] = part_at(faces, nowhere);
    line->on_boundary = flat;
    for (int i = 0; i < 6; i++)
        mpfr_clear(faces[i].t);
    return !beside && mpfr_lessequal_p(line->t[0], line->t[1]);
}

const test_shape test_shape_box = {
    .through = {{{0, -4, -4}, {8, 4, 4}, 0}, {{-4, -4, 0}, {4, 4, 8}, 0}},
    .companion = companion,
    .frame = frame,
    .in_object = in_box,
};
