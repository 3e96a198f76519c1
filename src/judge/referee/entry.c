/* SPDX-License-Identifier: MIT */
#include "entry.h"

#include "margin.h"

#include "../../numbers/sums.h"

#include <surehit/rotation.h>

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* The words. */

typedef struct {
    const char *word;
    size_t at; /* a bool, or one that has a value behind it */
} flag;

#define FLAG(word, member)                                                                         \
    {                                                                                              \
        word, offsetof(entry, member)                                                              \
    }
#define MISS(word, EVENT)                                                                          \
    {                                                                                              \
        word, offsetof(entry, misses) + EVENT_##EVENT * sizeof(bool)                               \
    }

static const flag flags[] = {
    FLAG("unit", unit),
    FLAG("aligned", aligned),
    FLAG("local", local),
    FLAG("centred", centred),
    FLAG("t_min=0", from_zero),
    FLAG("ray", ray),
    FLAG("segment", segment),
    FLAG("square", square),
    FLAG("float", in_float),
    FLAG("line", line),
    FLAG("outside", outside),
    FLAG("decision", decision),
    FLAG("wall", wall),
    FLAG("inside=0", zero_inside),
    MISS("touch=miss", TOUCH),
    MISS("surface=miss", SURFACE),
    MISS("inside=miss", INSIDE),
    MISS("end=miss", END),
    {NULL, 0},
};

static bool read_flag(const char *word, size_t length, entry *all)
{
    for (const flag *row = flags; row->word; row++) {
        if (strlen(row->word) == length && strncmp(word, row->word, length) == 0)
            return *(bool *)(void *)((char *)all + row->at) = true;
    }
    return false;
}

/* `scale=0.1..100`, `apart=1e-6` */
static bool read_value(const char *word, size_t length, entry *all)
{
    char *end = NULL;
    if (strncmp(word, "apart=", 6) == 0) {
        all->apart = strtod(word + 6, &end);
        return end == word + length && all->apart > 0 && all->apart < 1 && (all->outside = true);
    }
    if (strncmp(word, "scale=", 6) != 0)
        return false;
    all->least = strtod(word + 6, &end);
    end -= end > word + 6 && end[-1] == '.'; /* of `1..2` it takes the first point, too */
    if (strncmp(end, "..", 2) != 0)
        return false;
    all->most = strtod(end + 2, &end);
    return end == word + length && all->least > 0 && all->most >= 4 * all->least &&
           all->most <= DBL_MAX;
}

const char *entry_read(const char *text, entry *all)
{
    *all = (entry){0};
    for (const char *word = text; *word != '\0';) {
        size_t length = strcspn(word, ", ");
        if (length > 0 && !read_flag(word, length, all) && !read_value(word, length, all))
            return "of unit, aligned, local, centred, t_min=0, ray, segment, line, outside, "
                   "apart=SIZES, scale=A..B (B at least 4 A), square, float, decision, wall, "
                   "touch=miss, surface=miss, inside=miss, inside=0, end=miss";
        all->declared |= length > 0;
        word += length + (word[length] != '\0');
    }
    if (all->wall && all->apart > 0)
        return "of wall and apart at most one";
    return all->ray && all->segment ? "of ray and segment at most one" : NULL;
}

/* The case is made so. */

/* Rows of a rotation that takes v to where the entry wants it; without rounding where v is along an
 * axis already. */
static sure_mat3 turn_to_z(sure_vec3 v)
{
    double length = sqrt(dot(v, v));
    sure_vec3 w = scaled(1 / length, v);
    if (v.x == 0 && v.y == 0)
        return (sure_mat3){{{1, 0, 0}, {0, v.z < 0 ? -1 : 1, 0}, {0, 0, v.z < 0 ? -1 : 1}}};
    if (v.y == 0 && v.z == 0)
        return (sure_mat3){{{0, v.x < 0 ? 1 : -1, 0}, {0, 0, -1}, {v.x < 0 ? -1 : 1, 0, 0}}};
    if (v.x == 0 && v.z == 0)
        return (sure_mat3){{{v.y < 0 ? -1 : 1, 0, 0}, {0, 0, -1}, {0, v.y < 0 ? -1 : 1, 0}}};
    double across = sqrt(w.x * w.x + w.y * w.y);
    sure_vec3 u = {-w.y / across, w.x / across, 0};
    return (sure_mat3){{{u.x, u.y, u.z},
                        {w.y * u.z - w.z * u.y, w.z * u.x - w.x * u.z, w.x * u.y - w.y * u.x},
                        {w.x, w.y, w.z}}};
}

static const sure_shape_field *second_field(const sure_case *c)
{
    const sure_shape_info *info = sure_shape_info_of(c->object.shape);
    return info->field_count > 1 && info->fields[1].kind != SURE_KIND_RADIUS ? &info->fields[1]
                                                                             : NULL;
}

/* The axis goes along +z: everything is turned about the object's first point. A box stays. */
static void turn_case(sure_case *c)
{
    const sure_shape_field *second = second_field(c);
    if (!second || second->kind == SURE_KIND_HIGH)
        return;
    sure_vec3 *at = case_vector(c, AT_OBJECT + second->at), centre = *case_vector(c, AT_OBJECT);
    bool is_point = second->kind == SURE_KIND_OTHER_POINT;
    sure_vec3 axis = is_point ? add(*at, negate(centre)) : *at;
    sure_mat3 turn = turn_to_z(axis);
    sure_vec3 from = add(c->ray.origin, negate(centre));
    double height = is_point ? sqrt(dot(axis, axis)) : 1;
    c->ray.origin = add(centre, sure_rotation_apply_textbook(&turn, from));
    c->ray.direction = sure_rotation_apply_textbook(&turn, c->ray.direction);
    *at = (sure_vec3){is_point ? centre.x : 0, is_point ? centre.y : 0,
                      is_point ? centre.z + height : height};
}

/* By a vector, as rounded. */
static void move_case(sure_case *c, sure_vec3 by)
{
    const sure_shape_field *second = second_field(c);
    sure_vec3 *first = case_vector(c, AT_OBJECT);
    c->ray.origin = add(c->ray.origin, by);
    *first = add(*first, by);
    if (!second || second->kind == SURE_KIND_NORMAL)
        return;
    sure_vec3 *other = case_vector(c, AT_OBJECT + second->at);
    *other = add(*other, by);
}

/* The middle of the two points goes to the origin; both are as far from it. */
static void centre_case(sure_case *c)
{
    const sure_shape_field *second = second_field(c);
    if (!second || second->kind == SURE_KIND_NORMAL)
        return;
    sure_vec3 *other = case_vector(c, AT_OBJECT + second->at);
    sure_vec3 half = scaled(0.5, *other); /* the first is 0 */
    c->ray.origin = add(c->ray.origin, negate(half));
    *case_vector(c, AT_OBJECT) = negate(half);
    *other = half;
}

static void start_at_zero(sure_case *c)
{
    c->ray.origin = add(c->ray.origin, scaled(c->ray.t_min, c->ray.direction));
    c->ray.t_max -= c->ray.t_min;
    c->ray.t_min = 0;
}

/* As far as all of the object, twice, where it was infinite. */
static void end_somewhere(sure_case *c)
{
    sure_vec3 way = add(*case_vector(c, AT_OBJECT), negate(c->ray.origin));
    double size = object_size(&c->object), distance = sqrt(dot(way, way));
    if (c->ray.t_max > DBL_MAX)
        c->ray.t_max = 2 * (distance + 4 * size) / sqrt(dot(c->ray.direction, c->ray.direction));
}

static void make_unit(sure_case *c)
{
    double length = sqrt(dot(c->ray.direction, c->ray.direction));
    c->ray.direction = scaled(1 / length, c->ray.direction);
    c->ray.t_min *= length;
    c->ray.t_max *= length;
}

/* Half as many digits. */
static void make_square(sure_case *c, precision in)
{
    const sure_shape_info *info = sure_shape_info_of(c->object.shape);
    for (int i = 0; i < info->field_count; i++) {
        int exponent;
        double *at = case_number(c, AT_OBJECT + info->fields[i].at);
        if (info->fields[i].kind != SURE_KIND_RADIUS)
            continue;
        double digits = in == PRECISION_FLOAT ? 12 : 26, mantissa = frexp(*at, &exponent);
        *at = ldexp(rint(ldexp(mantissa, (int)digits)), exponent - (int)digits);
    }
}

/* Lengths by a power of two that brings the object's size among the entry's. */
static void scale_case(sure_case *c, const entry *all)
{
    double size = object_size(&c->object);
    int exponent = 0;
    if (size > 0 && (size < all->least || size > all->most / 2))
        (void)frexp(all->least / size, &exponent);
    for (int i = 0; i < case_numbers(c->object.shape); i++) {
        number_kind what = case_number_kind(c->object.shape, i);
        if (what == IS_LENGTH || what == IS_TIME)
            *case_number(c, i) = ldexp(*case_number(c, i), exponent);
    }
}

/* What is not so isn't asked. */

static bool is_in_scale(const entry *all, const sure_case *question)
{
    bool has_size = sure_shape_info_of(question->object.shape)->bounded;
    return (!has_size || object_size(&question->object) >= all->least) &&
           margin_length(question, MARGIN_DISTANCE, PRECISION_DOUBLE) <= all->most;
}

/* Is the range's start off the object, and off all whose faces are not farther away? */
static bool is_apart(const entry *all, const sure_case *question)
{
    static const case_answer none = {.status = SURE_MISS};
    sure_case start = *question;
    reply hit = {.status = SURE_HIT};
    event which = event_of(question, &none, FAULTS, &hit);
    start.ray.t_max = start.ray.t_min;
    return which != EVENT_SURFACE && which != EVENT_INSIDE &&
           (all->apart == 0 ||
            margin_beyond_length(&start, FAULT_FALSE_HIT, &hit,
                                 all->apart *
                                     margin_length(question, MARGIN_SIZE, PRECISION_DOUBLE)));
}

/* Nothing of the object on the ray backwards. */
static bool is_all_ahead(const sure_case *question)
{
    sure_ray back = question->ray;
    back.direction = negate(back.direction);
    back.t_min = 0;
    back.t_max = INFINITY;
    return question->ray.t_min == 0 && !case_is_hit(question, &back);
}

static bool may_be_asked(const entry *all, const sure_case *question)
{
    return (all->most == 0 || is_in_scale(all, question)) &&
           (!all->outside || is_apart(all, question)) && (!all->line || is_all_ahead(question));
}

static void make_frame(const entry *all, sure_case *c)
{
    if (all->local || all->centred)
        move_case(c, negate(*case_vector(c, AT_OBJECT)));
    if (all->local || all->centred || all->aligned)
        turn_case(c);
    if (all->centred)
        centre_case(c);
}

static void make_range(const entry *all, sure_case *c)
{
    if (all->from_zero || all->ray || all->segment)
        start_at_zero(c);
    if (all->ray)
        c->ray.t_max = INFINITY;
    if (all->segment)
        end_somewhere(c);
}

/* Is the direction's length 1 but for the rounding of its components? */
static bool is_unit(const sure_case *question, precision in)
{
    double off = dot(question->ray.direction, question->ray.direction) - 1;
    return fabs(off) <= (in == PRECISION_FLOAT ? 0x1p-22 : 0x1p-51);
}

/* As the entry wants it, as near as doubles or floats can. */
static sure_case case_made(const entry *all, const sure_case *question, precision in)
{
    sure_case made = *question, rounded;
    make_frame(all, &made);
    make_range(all, &made);
    if (all->unit && !is_unit(&made, in)) /* what is, stays: it may be asked again */
        make_unit(&made);
    if (all->most > 0)
        scale_case(&made, all);
    if (all->square)
        make_square(&made, in);
    if (in == PRECISION_FLOAT) /* what has no floats is invalid now */
        (void)float_case(&made, &rounded);
    return in == PRECISION_FLOAT ? rounded : made;
}

static bool same_case(const sure_case *a, const sure_case *b)
{
    double x[CASE_NUMBERS_MAX], y[CASE_NUMBERS_MAX];
    int same = 0, count = case_numbers(a->object.shape);
    case_to_numbers(a, x);
    case_to_numbers(b, y);
    while (same < count && (x[same] == y[same] || (isnan(x[same]) && isnan(y[same]))))
        same++;
    return same == count;
}

static bool is_wall(const entry *all, const sure_case *question)
{
    return all->wall && case_has_wall(question->object.shape);
}

bool entry_holds(const entry *all, const sure_case *question, precision in)
{
    const sure_case made = case_made(all, question, in);
    return same_case(question, &made) &&
           (!all->declared ||
            (sure_object_check(&question->ray, &question->object) == SURE_FIELD_NONE &&
             may_be_asked(all, question)));
}

bool entry_case(const entry *all, const sure_case *question, precision in, sure_case *received)
{
    *received = *question;
    received->wall = is_wall(all, question);
    if (!all->declared)
        return in == PRECISION_DOUBLE || float_case(question, received);
    if (sure_object_check(&question->ray, &question->object) != SURE_FIELD_NONE)
        return false;
    *received = case_made(all, received, in);
    return entry_holds(all, received, in);
}

bool entry_allows(const entry *all, event which, const sure_case *question, fault of,
                  const reply *given)
{
    if (which == EVENT_INSIDE && all->zero_inside && given->status == SURE_HIT)
        return given->t == question->ray.t_min;
    return of == FAULT_FALSE_MISS && all->misses[which];
}
