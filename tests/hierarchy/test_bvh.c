/* SPDX-License-Identifier: MIT */
/* The hierarchy loses no hit. By exact arithmetic: boxes hold their objects, and rays that meet a
 * box are never told that they don't; in every rounding mode, with subnormals kept and flushed.
 * Every object is found where the hierarchy has it, and with it or without every ray sees the same.
 * docs/proofs/bvh.md says why. */
#include "../support/box_truth.h"
#include "../support/every_case.h"
#include "../support/small_scene.h"
#include "../support/surroundings.h"
#include "packet_boxes.h"

#include "../../src/hierarchy/bvh_build.h"
#include "../../src/hierarchy/bvh_walk.h"
#include "../../src/geometry/coordinate.h"

enum { SEED = 70, USUAL = 0 };

/* What is computed in an environment is the library's, or called by a volatile pointer: out of the
 * compiler's sight. */
#define IN(environment, computation)                                                               \
    do {                                                                                           \
        surroundings_set(environment);                                                             \
        computation;                                                                               \
        surroundings_set(USUAL);                                                                   \
    } while (0)

/* Every how many cases are tried. */
static uint64_t share(void)
{
    return suite_setting("SUREHIT_SHARE", 1);
}

static const char *text_of(const sure_ray *ray, const sure_object *object)
{
    return case_text(&(sure_case){.ray = *ray, .object = *object});
}

/* Numbers. */

/* x, or close to it; finite. */
static double nearly(rng *d, double x)
{
    bool exactly = rng_chance(d, 1, 2);
    double near = exactly ? x : step_ulps(x, rng_integer(d, -4, 4));
    return fmin(fmax(isnan(near) ? x : near, -DBL_MAX), DBL_MAX);
}

/* Of every size that doubles have. */
static double wild(rng *d)
{
    static const int sizes[][2] = {{-1074, -1060}, {-1024, -1018}, {-1000, -880},
                                   {-530, -445},   {-60, 60},      {-2, 3},
                                   {495, 520},     {880, 1003},    {1020, 1024}};
    const int classes = sizeof sizes / sizeof *sizes;
    int class = rng_integer(d, 0, classes);
    double sign = rng_sign(d);
    return class == classes ? 0 : sign * rng_magnitude(d, sizes[class][0], sizes[class][1]);
}

/* All coordinates of one size, but now and then one of any. */
static sure_vec3 vector_of_size(rng *d, double size)
{
    double v[3];
    for (int i = 0; i < 3; i++)
        v[i] = rng_integer(d, -8, 8) * size;
    if (rng_chance(d, 1, 8))
        v[rng_integer(d, 0, 2)] = wild(d);
    return (sure_vec3){v[0], v[1], v[2]};
}

/* A power of two: mostly 1, now and then any. */
static double unit_of(rng *d)
{
    return rng_chance(d, 1, 2) ? 1 : ldexp(1, rng_integer(d, -1074, 1015));
}

static bool is_valid(const sure_ray *ray, const sure_object *object)
{
    return case_is_valid(&(sure_case){.ray = *ray, .object = *object});
}

static const sure_ray any_ray = {{0, 0, 0}, {1, 0, 0}, 0, 1};

/* Boxes hold their objects, and not much else. */

/* What a box may be larger by: docs/proofs/bvh.md, "How tight". */
#define TIGHT_SHARE 0x1p-47
#define TIGHT_MORE 0x1p-958

static double size_of(const sure_object *object, int axis)
{
    const sure_shape_info *info = sure_shape_info_of(object->shape);
    double size = 0;
    for (int i = 0; i < info->field_count; i++) {
        const double *field = (const double *)&object->as + info->fields[i].at;
        if (info->fields[i].kind == SURE_KIND_RADIUS)
            size += *field;
        else if (info->fields[i].kind != SURE_KIND_NORMAL)
            size += fabs(field[axis]);
    }
    return size;
}

/* Is the axis one whose squares are known, and nothing far? */
static bool is_usual(const sure_object *object)
{
    const sure_shape_info *info = sure_shape_info_of(object->shape);
    const double *numbers = (const double *)&object->as;
    double greatest = 0, length = 0;
    for (int i = 0; i < info->numbers; i++)
        greatest = fmax(greatest, fabs(numbers[i]));
    if (info->field_count == 2)
        return greatest < 0x1p990;
    for (int i = 0; i < 3; i++) {
        double from = info->fields[1].kind == SURE_KIND_NORMAL ? 0 : numbers[i];
        length = fmax(length, fabs(numbers[3 + i] - from));
    }
    return greatest < 0x1p990 && length > 0x1p-440 && length < 0x1p490;
}

static void check_face(const sure_object *object, const sure_bounds *box, int face, int environment)
{
    const int axis = face / 2;
    const bool up = face % 2;
    const double at = up ? box->high[axis] : box->low[axis];
    double more = TIGHT_SHARE * size_of(object, axis) + TIGHT_MORE;
    ck_assert_msg(box_truth_room(object, axis, up, at) >= 0, "%s: face %d, %a cuts off some of %s",
                  surroundings_name(environment), face, at, text_of(&any_ray, object));
    ck_assert_msg(!is_usual(object) ||
                      box_truth_room(object, axis, up, up ? at - more : at + more) < 0,
                  "%s: face %d, %a is too far from %s", surroundings_name(environment), face, at,
                  text_of(&any_ray, object));
}

/* In each environment; what is the same in the next one is not judged again. */
static void check_box(const sure_object *object)
{
    sure_bounds box, last = {{NAN, NAN, NAN}, {NAN, NAN, NAN}};
    for (int e = 0; e < SURROUNDINGS_ALL; e++) {
        bool bounded;
        IN(e, bounded = sure_bvh_box(object, &box));
        ck_assert_int_eq(bounded, sure_shape_info_of(object->shape)->bounded);
        for (int face = 0; bounded && memcmp(&box, &last, sizeof box) != 0 && face < 6; face++)
            check_face(object, &box, face, e);
        last = box;
    }
}

static sure_object wild_object(rng *d, sure_shape shape)
{
    double numbers[CASE_NUMBERS_MAX], unit = unit_of(d);
    case_to_numbers(&(sure_case){.ray = any_ray, .object.shape = shape}, numbers);
    bool wilder = rng_chance(d, 1, 2);
    for (int i = 8; i < case_numbers(shape); i++)
        numbers[i] = wilder ? wild(d) : rng_integer(d, -8, 8) * unit;
    object_mend(shape, numbers + 8);
    return case_from_numbers(shape, numbers).object;
}

/* A ray and the boxes of a node. */
typedef struct {
    sure_bvh_node node;
    sure_ray ray;
    double enter[SURE_BVH_WIDTH];
    uint64_t meets[SURE_BVH_WIDTH];
    bool kept[SURE_BVH_WIDTH];
    int child;
    unsigned together; /* of a packet of such rays, who meets the child's box */
} walk;

static void walk_together(walk *w)
{
#ifdef BOXES_TOGETHER
    const double numbers[] = {w->ray.origin.x,    w->ray.origin.y,    w->ray.origin.z,
                              w->ray.direction.x, w->ray.direction.y, w->ray.direction.z,
                              w->ray.t_min};
    boxes_column rays[7], t_max, endless;
    for (int i = 0; i < BOXES_PACKET; i++) {
        for (int k = 0; k < 7; k++)
            rays[k][i] = numbers[k];
        t_max[i] = w->ray.t_max;
        endless[i] = INFINITY;
    }
    w->together = packet_boxes_met(&w->node, w->child, rays, t_max, endless);
#else
    w->together = w->meets[w->child] ? 0xff : 0;
#endif
}

/* With t_max known, and found out later. */
static void walk_boxes(walk *w)
{
    bvh_probe probe = bvh_probe_of(&w->ray);
    uint64_t at_all[SURE_BVH_WIDTH];
    bvh_meets(&w->node, &probe, INFINITY, w->enter, at_all);
    for (int k = 0; k < SURE_BVH_WIDTH; k++)
        w->kept[k] = at_all[k] && !(w->enter[k] > w->ray.t_max + probe.slack);
    bvh_meets(&w->node, &probe, w->ray.t_max, w->enter, w->meets);
    walk_together(w);
}

static void (*volatile ask_walk)(walk *) = walk_boxes;

/* The box alone in child k, other boxes in the others or nothing. */
static sure_bvh_node node_of(const sure_bounds *box, int child, const sure_bounds *others)
{
    sure_bvh_node node = {.count = {0}};
    for (int i = 0; i < 3 * SURE_BVH_WIDTH; i++) {
        const int k = i / 3, axis = i % 3;
        const sure_bounds *own = k == child ? box : others;
        node.bound[2 * axis][k] = own ? own->low[axis] : INFINITY;
        node.bound[2 * axis + 1][k] = own ? own->high[axis] : -INFINITY;
    }
    return node;
}

static const char *box_text(const sure_bounds *box)
{
    static char text[512];
    snprintf(text, sizeof text, "[%a, %a] x [%a, %a] x [%a, %a]", box->low[0], box->high[0],
             box->low[1], box->high[1], box->low[2], box->high[2]);
    return text;
}

static const sure_object no_object = {SURE_SHAPE_SPHERE, {.sphere = {{0, 0, 0}, 0}}};

/* The ray meets the box by exact arithmetic: it has to be told so. */
static void require_met(const sure_ray *ray, const sure_bounds *box, int environment, int child,
                        const char *what)
{
    const sure_bounds other = {{1, 2, -3}, {2, 5, 3}};
    for (int beside = 0; beside < 2; beside++) {
        walk w = {.ray = *ray, .node = node_of(box, child, beside ? &other : NULL), .child = child};
        IN(environment, ask_walk(&w));
        ck_assert_msg(w.meets[child] && w.kept[child] && w.together == 0xff,
                      "%s: lost: ray of %s, box %s, %s, child %d, %d beside; together %x",
                      surroundings_name(environment), text_of(ray, &no_object), box_text(box), what,
                      child, beside, w.together);
    }
}

/* Is it told so, or not? */
static bool is_met(const sure_ray *ray, const sure_bounds *box)
{
    walk w = {.ray = *ray, .node = node_of(box, 0, NULL)};
    ask_walk(&w);
    ck_assert(w.kept[0] || !w.meets[0]);
    ck_assert_uint_eq(w.together, w.meets[0] ? 0xff : 0);
    return w.meets[0];
}

/* Boxes that rays graze. */

/* Ends as sure_bvh_box has them. */
static double low_end(double x)
{
    return x < -SURE_BVH_FAR ? -INFINITY : fmin(x, SURE_BVH_FAR);
}

static double high_end(double x)
{
    return -low_end(-x);
}

/* A face at or next to where the ray is at t, or next to its origin. */
static void draw_faces(rng *d, double o, double p, double *low, double *high)
{
    double size = rng_integer(d, 0, 8) * unit_of(d), first, second;
    int kind = rng_integer(d, 0, 6);
    first = nearly(d, p);
    second = nearly(d, p);
    switch (kind) {
    case 0: break;
    case 1: second = first + size; break;
    case 2: second = first - size; break;
    case 3: first = -INFINITY; break;
    case 4: first = INFINITY; break;
    case 5:
        first = p - size;
        second = p + size;
        break;
    default: second = nearly(d, o);
    }
    *low = low_end(fmin(first, second));
    *high = high_end(fmax(first, second));
}

static double draw_t(rng *d)
{
    switch (rng_integer(d, 0, 3)) {
    case 0: return rng_integer(d, 0, 8);
    case 1: return rng_integer(d, 1, 8) * unit_of(d);
    case 2: return rng_magnitude(d, -4, 4);
    default: return fabs(wild(d));
    }
}

/* A range that ends at t, next to it, or anywhere. */
static void draw_range(rng *d, double t, sure_ray *ray)
{
    ray->t_min = rng_chance(d, 1, 2) ? 0 : fabs(nearly(d, t));
    ray->t_max = rng_chance(d, 1, 2) ? INFINITY : fmax(ray->t_min, fabs(nearly(d, t)));
}

static sure_ray draw_ray(rng *d, double unit)
{
    double speed = rng_chance(d, 1, 2) ? unit : unit_of(d);
    sure_vec3 origin = vector_of_size(d, unit), direction = vector_of_size(d, speed);
    if (direction.x == 0 && direction.y == 0 && direction.z == 0)
        direction.y = -speed;
    if (rng_chance(d, 1, 16))
        for (int i = 0; i < 3; i++)
            *coordinate_of(&origin, i) = wild(d);
    if (rng_chance(d, 1, 4)) /* any digits */
        direction.x *= rng_magnitude(d, -1, 1);
    return (sure_ray){origin, direction, 0, INFINITY};
}

LOOP_TEST(test_walk, 3)
{
    enum { BOXES = 100000 };
    uint64_t met = 0, missed = 0, told = 0;
    for (uint64_t i = 0; i < BOXES; i += share()) {
        rng d = rng_of(SEED, (uint64_t)_i, 101, i);
        sure_ray ray = draw_ray(&d, unit_of(&d));
        double t = draw_t(&d);
        sure_bounds box;
        draw_range(&d, t, &ray);
        for (int k = 0; k < 3; k++) {
            double o = coordinate(ray.origin, k), p = o + t * coordinate(ray.direction, k);
            draw_faces(&d, o, fmin(fmax(p, -DBL_MAX), DBL_MAX), &box.low[k], &box.high[k]);
        }
        if (!is_valid(&ray, &no_object))
            continue;
        if (!box_truth_meets(&box, &ray)) {
            missed++;
            told += !is_met(&ray, &box);
            continue;
        }
        met++;
        for (int e = 0; e < SURROUNDINGS_ALL; e++)
            require_met(&ray, &box, e, (int)(i % SURE_BVH_WIDTH), "aimed");
    }
    printf("walk %d: %lu met, %lu missed, %lu of them told\n", _i, (unsigned long)met,
           (unsigned long)missed, (unsigned long)told);
    ck_assert_uint_gt(met, BOXES / 8 / share());
    ck_assert_uint_gt(missed, BOXES / 8 / share());
    ck_assert_uint_gt(told, missed / 4); /* most others are a few doubles away */
}

/* An unused child is met by no ray of usual numbers. */
TEST(test_unused)
{
    for (int i = 0; i < 27; i++) {
        const sure_vec3 along = {i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
        walk w = {.ray = {{1, 2, 3}, along, 0, INFINITY}};
        w.node = node_of(NULL, 0, NULL);
        if (i == 13)
            continue;
        ask_walk(&w);
        for (int k = 0; k < SURE_BVH_WIDTH; k++)
            ck_assert(!w.meets[k] && !w.kept[k]);
    }
}

/* Hits lie in the object's box. */

/* The ray's hit on the object by `exact`, in a range no longer than it has to be. */
static bool hit_alone(const sure_ray *ray, const sure_object *object, sure_ray *alone)
{
    sure_hit hit;
    if (sure_object_hit(ray, object, SURE_TIER_EXACT, &hit) != SURE_HIT)
        return false;
    bool whole = hit.t_error == 0;
    double before = hit.t > 0 ? fmin(nextafter(hit.t, 0), DBL_MAX) : 0;
    *alone = *ray;
    alone->t_min = fmax(ray->t_min, whole ? hit.t : before);
    alone->t_max = fmin(ray->t_max, whole ? hit.t : nextafter(hit.t, INFINITY));
    return true;
}

/* Each point where the ray meets the object is in its box, and the ray is told so: how many. */
static int check_hits(const sure_case *c, uint64_t index)
{
    sure_ray rest = c->ray, alone;
    int hits = 0;
    for (; hits < 2 && hit_alone(&rest, &c->object, &alone); hits++) {
        for (int e = 0; e < SURROUNDINGS_ALL; e++) {
            sure_bounds box;
            bool bounded;
            int child = (int)((index + (uint64_t)e) % SURE_BVH_WIDTH);
            IN((e + (int)index) % SURROUNDINGS_ALL, bounded = sure_bvh_box(&c->object, &box));
            if (!bounded)
                return 0;
            require_met(&alone, &box, e, child, text_of(&c->ray, &c->object));
        }
        if (!(alone.t_max < fmin(rest.t_max, DBL_MAX)))
            return hits + 1;
        rest.t_min = nextafter(alone.t_max, INFINITY);
    }
    return hits;
}

/* Rays through the points where objects touch their boxes. */

static const int axes[][3] = {{1, 0, 0},  {0, -1, 0}, {0, 0, 1},  {3, 4, 0},
                              {0, -3, 4}, {4, 0, -3}, {5, 12, 0}, {0, 8, 15},
                              {1, 1, 1},  {1, -2, 3}, {0, 1, 1},  {1000, 1, 0}};
#define AXES (sizeof axes / sizeof *axes)

/* Along coordinate i a disc's rim is farthest from its centre in this direction, times r. */
static sure_vec3 farthest(const double axis[3], int i, double r)
{
    double whole = axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2];
    double across = whole - axis[i] * axis[i], way[3];
    double per = across > 0 ? r / sqrt(across * whole) : 0;
    for (int k = 0; k < 3; k++)
        way[k] = (k == i ? across : -axis[i] * axis[k]) * per;
    return vector_of(way);
}

/* Of whole numbers, and a point where it touches its box. */
static sure_object touching(rng *d, sure_shape shape, int i, double unit, sure_vec3 *at)
{
    const int *along = axes[rng_integer(d, 0, AXES - 1)];
    double side = rng_sign(d);
    double height = rng_integer(d, 1, 4) * rng_sign(d), r = rng_integer(d, 0, 13) * unit;
    sure_vec3 centre = vector_of_size(d, unit), axis, rim;
    double v[3] = {along[0] * height, along[1] * height, along[2] * height};
    axis = vector_of(v);
    rim = farthest(v, i, side * r);
    sure_vec3 end = plus(centre, times(unit, axis));
    const sure_shape_info *info = sure_shape_info_of(shape);
    bool has_end = info->fields[1].kind == SURE_KIND_OTHER_POINT;
    bool has_top = info->parts[1] == SURE_PART_TOP, is_box = shape_has(shape, SURE_KIND_HIGH);
    *at = plus(centre, rim);
    if (has_end && rng_chance(d, 1, 2))
        *at = has_top ? plus(end, rim) : end;
    if (is_box) {
        *at = rng_chance(d, 1, 2) ? centre : end;
    } else if (info->field_count == 2) {
        double way[3] = {0, 0, 0};
        way[i] = side * r;
        *at = plus(centre, vector_of(way));
    }
    return object_made(shape, centre, axis, end, r);
}

static sure_vec3 nearly_vector(rng *d, sure_vec3 p)
{
    double x = nearly(d, p.x), y = nearly(d, p.y), z = nearly(d, p.z);
    return (sure_vec3){x, y, z};
}

/* Directions: in the face across coordinate i, across it, any. */
static sure_vec3 grazing(rng *d, int i, double unit)
{
    double way[3] = {0, 0, 0};
    int kind = rng_integer(d, 0, 4);
    for (int k = 0; k < 3; k++)
        way[k] = rng_integer(d, -3, 3) * unit;
    if (kind <= 1)
        way[i] = 0;
    if (kind == 1)
        way[(i + 1) % 3] = 0;
    if (kind == 2)
        way[i] = wild(d);
    if (kind == 3)
        way[i] = rng_sign(d) * rng_magnitude(d, -60, -20) * unit;
    if (way[0] == 0 && way[1] == 0 && way[2] == 0)
        way[(i + 2) % 3] = -unit;
    return vector_of(way);
}

static sure_case touching_case(sure_shape shape, uint64_t index)
{
    rng d = rng_of(SEED, (uint64_t)shape, 102, index);
    double unit = unit_of(&d), speed = rng_chance(&d, 1, 2) ? unit : unit_of(&d);
    int i = rng_integer(&d, 0, 2);
    sure_vec3 at, way;
    sure_case c = {.object = touching(&d, shape, i, unit, &at)};
    if (rng_chance(&d, 1, 2))
        at = nearly_vector(&d, at);
    way = grazing(&d, i, speed);
    double t = rng_integer(&d, 0, 8) * (unit / speed);
    c.ray = (sure_ray){plus(at, times(-t, way)), way, 0, INFINITY};
    if (rng_chance(&d, 1, 4))
        c.ray.origin = nearly_vector(&d, c.ray.origin);
    if (rng_chance(&d, 1, 2))
        draw_range(&d, t, &c.ray);
    return c;
}

/* What a hierarchy is made of. */

typedef struct {
    const sure_object *objects;
    size_t count;
    const sure_bvh *bvh;
    uint8_t *seen; /* how often, by object */
    uint32_t nodes, deepest;
    bool exactly;  /* whether a box holds what is below it */
    double widest; /* a leaf may be, unless 0 */
} inspection;

static sure_bounds child_box(const sure_bvh_node *node, int child)
{
    sure_bounds box;
    for (int i = 0; i < 3; i++) {
        box.low[i] = node->bound[2 * i][child];
        box.high[i] = node->bound[2 * i + 1][child];
    }
    return box;
}

static bool is_within(const sure_bounds *inner, const sure_bounds *outer)
{
    bool within = true;
    for (int i = 0; i < 3; i++)
        within = within && inner->low[i] >= outer->low[i] && inner->high[i] <= outer->high[i];
    return within;
}

static bool is_no_box(const sure_bounds *box)
{
    static const sure_bounds none = {{INFINITY, INFINITY, INFINITY},
                                     {-INFINITY, -INFINITY, -INFINITY}};
    return memcmp(box, &none, sizeof none) == 0;
}

static bool holds(const sure_bounds *box, const sure_object *object, bool exactly)
{
    sure_bounds own;
    if (!exactly)
        return sure_bvh_box(object, &own) && is_within(&own, box);
    bool held = true;
    for (int i = 0; i < 3; i++)
        held = held && box_truth_room(object, i, false, box->low[i]) >= 0 &&
               box_truth_room(object, i, true, box->high[i]) >= 0;
    return held;
}

static void inspect_leaf(inspection *of, uint32_t first, uint8_t count, const sure_bounds *box)
{
    for (int i = 0; i < 3 && of->widest > 0; i++)
        ck_assert(!(box->high[i] - box->low[i] > of->widest));
    for (size_t i = first; i < (size_t)first + count; i++) {
        ck_assert_uint_ge(i, of->bvh->unbounded);
        ck_assert_uint_lt(i, of->count);
        uint32_t object = of->bvh->slots[i];
        ck_assert_uint_lt(object, of->count);
        of->seen[object]++;
        ck_assert_msg(holds(box, &of->objects[object], of->exactly), "not in the box: %s",
                      text_of(&any_ray, &of->objects[object]));
    }
}

/* The node and all below, whose boxes lie in `box`. */
static void inspect_node(inspection *of, uint32_t index, uint32_t depth, const sure_bounds *box)
{
    const sure_bvh_node *node = &of->bvh->nodes[index];
    of->nodes++;
    of->deepest = depth > of->deepest ? depth : of->deepest;
    ck_assert_uint_le(depth, SURE_BVH_DEPTH);
    for (int k = 0; k < SURE_BVH_WIDTH; k++) {
        sure_bounds own = child_box(node, k);
        ck_assert(node->count[k] == 0 ? is_no_box(&own) : is_within(&own, box));
        if (node->count[k] != SURE_BVH_INNER) {
            inspect_leaf(of, node->first[k], node->count[k], &own);
        } else {
            ck_assert_uint_gt(node->first[k], index); /* no way leads back */
            inspect_node(of, node->first[k], depth + 1, &own);
        }
    }
}

static void inspect(inspection *of)
{
    const sure_bounds all = {{-INFINITY, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}};
    const sure_bvh *bvh = of->bvh;
    size_t bounded = bvh_bounded(of->objects, of->count);
    of->seen = calloc(of->count + 1, 1);
    ck_assert_ptr_nonnull(of->seen);
    ck_assert_uint_eq(bvh->unbounded, of->count - bounded);
    ck_assert((bvh->nodes != NULL) == (bounded > 0));
    for (size_t i = 0; i < bvh->unbounded; i++) {
        ck_assert_uint_lt(bvh->slots[i], of->count);
        ck_assert_int_eq(of->objects[bvh->slots[i]].shape, SURE_SHAPE_PLANE);
        of->seen[bvh->slots[i]]++;
    }
    if (bvh->nodes)
        inspect_node(of, 0, 1, &all);
    for (size_t i = 0; i < of->count; i++)
        ck_assert_int_eq(of->seen[i], 1);
    free(of->seen);
}

/* The first bytes of a node are all there is. */
enum { NODE_BYTES = offsetof(sure_bvh_node, count) + SURE_BVH_WIDTH };

static bool same_hierarchy(const sure_bvh *a, const sure_bvh *b, size_t objects, uint32_t nodes)
{
    bool same =
        a->unbounded == b->unbounded && memcmp(a->slots, b->slots, objects * sizeof *a->slots) == 0;
    for (uint32_t i = 0; same && i < nodes; i++)
        same = memcmp(&a->nodes[i], &b->nodes[i], NODE_BYTES) == 0;
    return same;
}

static sure_object ground(double height)
{
    return plane(0, height, 0, 0, 1, 0);
}

/* Collections of objects that are hard to part: member i of one. */
typedef sure_object member(uint64_t i);

/* Each twice as far as the one before: any plane across the line leaves few on one side. */
static sure_object doubling_member(uint64_t i)
{
    int power = (int)(i % 2001);
    return sphere(ldexp(1, power - 1050), 0, 0, ldexp(1, power - 1060));
}

static sure_object large_small_member(uint64_t i)
{
    rng d = rng_of(SEED, 0, 103, i);
    double x = rng_between(&d, -1, 1), y = rng_between(&d, -1, 1);
    return sphere(x, y, rng_between(&d, -1, 1), rng_magnitude(&d, -300, 300));
}

static sure_object wild_member(uint64_t i)
{
    for (uint64_t k = 0;; k++) {
        rng d = rng_of(SEED, k, 104, i);
        sure_object object = wild_object(&d, (sure_shape)rng_integer(&d, 0, SURE_SHAPES - 1));
        if (is_valid(&any_ray, &object))
            return object;
    }
}

static sure_case regime_question(uint64_t i)
{
    for (uint64_t k = 0;; k++) {
        rng d = rng_of(SEED, k, 105, i);
        sure_shape shape = (sure_shape)rng_integer(&d, 0, SURE_SHAPES - 1);
        regime which = (regime)rng_integer(&d, 0, REGIMES - 1);
        if (!regime_applies(shape, which))
            continue;
        sure_case c = regime_case(shape, which, SEED, i);
        if (case_is_valid(&c))
            return c;
    }
}

static sure_object regime_member(uint64_t i)
{
    return regime_question(i).object;
}

static sure_object crowd_member(uint64_t i)
{
    rng d = rng_of(SEED, 0, 106, i);
    double x = rng_between(&d, -100, 100), z = rng_between(&d, -100, 100);
    return i % 1000 == 0 ? ground((double)i) : sphere(x, 0.5, z, rng_between(&d, 0.1, 0.5));
}

/* Heaps far apart in a row, their objects in the file in turns, and a plane: what shares a leaf is
 * of one heap, so that no leaf's box is wider. A hierarchy that parted them elsewhere would be
 * right, and slow. */
enum { HEAPS = 64, HEAPED = 4096, HEAP_WIDTH = 24 };

static sure_object heaped(uint64_t i, int axis)
{
    rng d = rng_of(SEED, 0, 108, i);
    double at[3];
    for (int k = 0; k < 3; k++)
        at[k] = rng_between(&d, -10, 10);
    at[axis] += 1000.0 * (double)(i * 37 % HEAPS);
    return i == HEAPED / 2 ? ground(0) : sphere(at[0], at[1], at[2], 1);
}

#define MEMBER(name, ...)                                                                          \
    static sure_object name##_member(uint64_t i)                                                   \
    {                                                                                              \
        const double n = (double)i;                                                                \
        return (void)n, __VA_ARGS__;                                                               \
    }
#define STEPS(i) (1 + (double)(i)*0x1p-52)

MEMBER(same, sphere(1, 2, 3, 0.5))
MEMBER(plane, ground(n))
MEMBER(concentric, sphere(0, 0, 0, 1 + n))
MEMBER(point, sphere(0.1 * (double)(i % 7), 0, 0, 0))
MEMBER(line, sphere(n, 0, 0, 0.25))
MEMBER(apart, sphere(100 * n, 0, 0, 1))
MEMBER(ulp, sphere(STEPS(i % 20), STEPS(i / 20 % 20), STEPS(i / 400), 0))
MEMBER(heap_x, heaped(i, 0))
MEMBER(heap_y, heaped(i, 1))
MEMBER(heap_z, heaped(i, 2))
MEMBER(endless, i % 3 == 0 ? sphere(n, 0, 0, 1) : sphere(0x1p1010, -0x1p1023, n, 0x1p1022))

static const struct {
    const char *name;
    member *make;
    size_t count;
    double widest; /* of a leaf, where that is told */
} collections[] = {
    {"nothing", same_member, 0, INFINITY},
    {"one", same_member, 1, INFINITY},
    {"one plane", plane_member, 1, INFINITY},
    {"planes", plane_member, 300, INFINITY},
    {"two", line_member, 2, INFINITY},
    {"as many as a leaf has", line_member, 9, INFINITY},
    {"identical", same_member, 10000, INFINITY},
    {"concentric", concentric_member, 5000, INFINITY},
    {"points in few places", point_member, 3000, INFINITY},
    {"a line", line_member, 10000, INFINITY},
    {"each in a leaf of its own", apart_member, 3000, 4},
    {"doubling", doubling_member, 20000, INFINITY},
    {"ulps apart", ulp_member, 8000, INFINITY},
    {"endless", endless_member, 2000, INFINITY},
    {"large and small", large_small_member, 5000, INFINITY},
    {"wild", wild_member, 3000, INFINITY},
    {"of all regimes", regime_member, 3000, INFINITY},
    {"a crowd", crowd_member, 30000, INFINITY},
    {"heaps along x", heap_x_member, HEAPED, HEAP_WIDTH},
    {"heaps along y", heap_y_member, HEAPED, HEAP_WIDTH},
    {"heaps along z", heap_z_member, HEAPED, HEAP_WIDTH},
};
#define COLLECTIONS (int)(sizeof collections / sizeof *collections)

static sure_object *make_all(member *make, size_t count)
{
    sure_object *objects = malloc((count + 1) * sizeof *objects);
    ck_assert_ptr_nonnull(objects);
    for (size_t i = 0; i < count; i++)
        objects[i] = make(i);
    return objects;
}

/* With the hierarchy and without every ray sees the same. */

/* Objects, and hierarchies of them that are walked in different orders. */
enum { ORDERS = 3, MOST_OBJECTS = 48 };

typedef struct {
    sure_object objects[MOST_OBJECTS];
    sure_bvh orders[ORDERS];
    sure_scene scene, by[ORDERS]; /* without, and by each */
} stage;

static void swap_children(sure_bvh_node *node, int a, int b)
{
    sure_bvh_node before = *node;
    for (int i = 0; i < 6; i++) {
        node->bound[i][a] = before.bound[i][b];
        node->bound[i][b] = before.bound[i][a];
    }
    node->first[a] = before.first[b];
    node->first[b] = before.first[a];
    node->count[a] = before.count[b];
    node->count[b] = before.count[a];
}

static void reverse_slots(uint32_t *first, uint32_t count)
{
    for (uint32_t i = 0; i < count / 2; i++) {
        uint32_t slot = first[i];
        first[i] = first[count - 1 - i];
        first[count - 1 - i] = slot;
    }
}

/* With every leaf's slots in reverse; with the nodes' children in reverse, too. */
static void reverse(sure_bvh *bvh, uint32_t nodes, bool children)
{
    sure_bvh_node *node = (sure_bvh_node *)bvh->nodes;
    for (; nodes > 0; nodes--, node++) {
        for (int k = 0; k < SURE_BVH_WIDTH; k++) {
            if (node->count[k] != SURE_BVH_INNER)
                reverse_slots((uint32_t *)bvh->slots + node->first[k], node->count[k]);
        }
        for (int k = 0; k < SURE_BVH_WIDTH / 2 && children; k++)
            swap_children(node, k, SURE_BVH_WIDTH - 1 - k);
    }
}

/* The first one is as built. */
static void set_stage(stage *on, size_t count)
{
    inspection of = {.objects = on->objects, .count = count, .bvh = on->orders};
    on->scene = (sure_scene){.objects = on->objects, .object_count = count};
    for (int order = 0; order < ORDERS; order++) {
        ck_assert(bvh_build(on->objects, count, 1, &on->orders[order]));
        if (order == 0)
            inspect(&of);
        else
            reverse(&on->orders[order], of.nodes, order > 1);
        on->by[order] = on->scene;
        on->by[order].bvh = &on->orders[order];
    }
}

static void free_stage(stage *on)
{
    for (int order = 0; order < ORDERS; order++)
        bvh_free(&on->orders[order]);
}

/* A question to a scene, and its answer. */
typedef struct {
    const sure_scene *scene;
    sure_tier tier;
    const sure_ray *ray;
    const sure_surface_point *leaving;
    sure_status status;
    sure_nearest nearest;
} sight;

static void look(sight *s, int environment)
{
    s->nearest = (sure_nearest){.object = 0};
    IN(environment,
       s->status = sure_backward_nearest(s->scene, s->tier, s->ray, s->leaving, &s->nearest));
}

static bool same_sight(const sight *a, const sight *b)
{
    const sure_hit *x = &a->nearest.hit, *y = &b->nearest.hit;
    return a->status == b->status && a->nearest.object == b->nearest.object &&
           bits_of(x->t) == bits_of(y->t) && bits_of(x->t_error) == bits_of(y->t_error) &&
           x->part == y->part;
}

static const char *sight_text(const sight *s)
{
    static char texts[2][2 * CASE_LINE_MAX];
    static int next;
    char *text = texts[next ^= 1];
    snprintf(text, sizeof *texts, "status %d, object %lu, t %a +- %a of\n%s", s->status,
             (unsigned long)s->nearest.object, s->nearest.hit.t, s->nearest.hit.t_error,
             text_of(s->ray, &s->scene->objects[s->nearest.object]));
    return text;
}

static void complain(const sight *s, const sight *truth, int order, int environment)
{
    ck_abort_msg("%s, %s, order %d: %s\nwithout: %s", sure_tier_name(s->tier),
                 surroundings_name(environment), order, sight_text(s), sight_text(truth));
}

/* Looks as `without` does, but by each hierarchy: the same bits. */
static void check_orders(const stage *on, const sight *without, int environment)
{
    for (int order = 0; order < ORDERS; order++) {
        sight with = *without;
        with.scene = &on->by[order];
        look(&with, environment);
        if (!same_sight(&with, without))
            complain(&with, without, order, environment);
    }
}

/* Environments that a question is asked in: the usual one, and others by turns. */
enum { TURNS = 3 };

static int turn(uint64_t number, int i)
{
    return i == 0 ? USUAL : (int)((number * (TURNS - 1) + (uint64_t)i) % SURROUNDINGS_ALL);
}

/* The truth is what `exact` sees when it asks every object in the usual environment. */
static sight check_sight(const stage *on, const sure_ray *ray, const sure_surface_point *leaving)
{
    static uint64_t number;
    sight truth = {.scene = &on->scene, .tier = SURE_TIER_EXACT, .ray = ray, .leaving = leaving};
    look(&truth, USUAL);
    number++;
    for (int i = 0; i < 2 * TURNS; i++) {
        int e = turn(number, i / 2);
        sight without = truth;
        without.tier = i % 2 == 0 ? SURE_TIER_CERTAIN : SURE_TIER_EXACT;
        look(&without, e);
        if (without.status != truth.status || without.nearest.object != truth.nearest.object)
            complain(&without, &truth, -1, e);
        check_orders(on, &without, e);
    }
    return truth;
}

static int check_way(const stage *on, const sure_surface_point *from, sure_vec3 light)
{
    static uint64_t number;
    int with, without = 0;
    number++;
    for (int i = 0; i < 2 * TURNS * ORDERS; i++) {
        int e = turn(number, i / 2 % TURNS);
        sure_tier tier = i % 2 == 0 ? SURE_TIER_CERTAIN : SURE_TIER_EXACT;
        IN(e, with = sure_shadow_reaches(&on->by[i / 2 / TURNS], tier, from, light));
        /* the way itself is rounded */
        IN(e, without = sure_shadow_reaches(&on->scene, tier, from, light));
        ck_assert_msg(with == without, "%s: reaches: %d with, %d without: %s", surroundings_name(e),
                      with, without,
                      text_of(&(sure_ray){from->point, light, 0, 1}, &on->objects[from->object]));
    }
    return without;
}

typedef struct {
    int rays, hits, ties, left, lit, shaded;
} tally;

/* On both sides of what is seen: another ray, and a light. */
static void check_leaving(const stage *on, rng *d, const sight *seen, tally *sum)
{
    const sure_object *object = &on->objects[seen->nearest.object];
    for (int side = 0; side < 2; side++) {
        sure_surface_point from = {.object = seen->nearest.object, .inside = side};
        if (!sure_spawn(seen->ray, object, &seen->nearest.hit, (sure_side)side, &from.point))
            continue;
        sure_ray ray = {from.point, vector_of_size(d, 1), 0, INFINITY};
        sure_vec3 light = vector_of_size(d, 1);
        if (object->shape <= SURE_SHAPE_DISC)
            from.inside = 0;
        if (!is_valid(&ray, object) || !(fabs(light.x + light.y + light.z) < 0x1p1000))
            continue;
        sum->left += check_sight(on, &ray, &from).status == SURE_HIT;
        int reaches = check_way(on, &from, light);
        sum->lit += reaches;
        sum->shaded += !reaches;
    }
}

/* Does an object of another index tie with what is seen? */
static bool ties(const stage *on, const sight *seen)
{
    sure_hit hit;
    for (size_t i = seen->nearest.object + 1; i < on->scene.object_count; i++) {
        const sure_object *other = &on->objects[i];
        if (sure_object_hit(seen->ray, other, SURE_TIER_EXACT, &hit) == SURE_HIT &&
            sure_hit_order(seen->ray, &on->objects[seen->nearest.object], &seen->nearest.hit, other,
                           &hit) == 0)
            return true;
    }
    return false;
}

static void check_ray(const stage *on, rng *d, const sure_ray *ray, tally *sum)
{
    sight seen = check_sight(on, ray, NULL);
    sum->rays++;
    if (seen.status != SURE_HIT)
        return;
    sum->hits++;
    sum->ties += ties(on, &seen);
    if (rng_chance(d, 1, 4))
        check_leaving(on, d, &seen, sum);
    /* The range ends, or begins, where it is met. */
    sure_ray alone;
    if (!rng_chance(d, 1, 2) || !hit_alone(ray, &on->objects[seen.nearest.object], &alone))
        return;
    check_sight(on, &alone, NULL);
    alone.t_max = INFINITY;
    check_sight(on, &alone, NULL);
}

/* Kinds of scenes. */
enum {
    LATTICE, /* of whole numbers */
    COPIES,  /* many of the same */
    DISTANT, /* of one, seen from far away: its t is not well known */
    ALIKE,   /* each a few doubles off the other */
    WALLS,   /* planes among the others */
    OF_REGIMES,
    WILD,
    KINDS
};

/* A scene in units; where an object of it touches its box, along which coordinate; rays that are
 * made for the objects. */
typedef struct {
    int kind, across;
    double unit;
    sure_vec3 at;
    sure_ray rays[MOST_OBJECTS];
} setting;

static sure_object lattice_object(rng *d, setting *in)
{
    sure_shape shape = (sure_shape)rng_integer(d, SURE_SHAPE_DISC, SURE_SHAPE_CONE);
    in->across = rng_integer(d, 0, 2);
    return touching(d, shape, in->across, in->unit, &in->at);
}

static sure_object scene_object(rng *d, setting *in, const sure_object *before, int i)
{
    switch (in->kind) {
    case COPIES: return i < 4 ? lattice_object(d, in) : before[rng_integer(d, 0, 3)];
    case DISTANT: return i < 1 ? lattice_object(d, in) : before[0];
    case ALIKE: return sphere(0, nearly(d, in->unit), 0, fabs(nearly(d, 3 * in->unit)));
    case WALLS:
        if (rng_chance(d, 1, 4))
            return ground(rng_integer(d, -4, 4) * in->unit);
        return lattice_object(d, in);
    case OF_REGIMES: {
        sure_case c = regime_question(rng_bits(d));
        in->rays[i] = c.ray;
        return c.object;
    }
    case WILD: return wild_member(rng_bits(d));
    default: return lattice_object(d, in);
    }
}

/* Straight to the point where an object touches its box, or next to that. */
static sure_ray distant_ray(rng *d, const setting *in)
{
    double way[3];
    for (int i = 0; i < 3; i++)
        way[i] = rng_integer(d, -3, 3) * 0x1p-40 * in->unit;
    way[in->across] = rng_sign(d) * rng_integer(d, 1, 3) * in->unit;
    sure_vec3 along = vector_of(way), back = times(-ldexp(1, rng_integer(d, 1, 40)), along);
    return (sure_ray){plus(in->at, back), along, 0, INFINITY};
}

static sure_ray scene_ray(rng *d, const stage *on, const setting *in)
{
    double at[CASE_NUMBERS_MAX];
    sure_ray ray = draw_ray(d, in->unit);
    int of = rng_integer(d, 0, (int)on->scene.object_count - 1);
    if (in->kind == DISTANT)
        return distant_ray(d, in);
    if (in->kind == OF_REGIMES && rng_chance(d, 1, 2))
        return in->rays[of];
    case_to_numbers(&(sure_case){.ray = any_ray, .object = on->objects[of]}, at);
    if (rng_chance(d, 1, 2)) /* towards the object's middle */
        ray.direction = (sure_vec3){at[8] / 4 - ray.origin.x / 4, at[9] / 4 - ray.origin.y / 4,
                                    at[10] / 4 - ray.origin.z / 4};
    return ray;
}

static void make_scene(rng *d, setting *in, stage *on)
{
    int count = 0, most = rng_integer(d, 1, MOST_OBJECTS);
    in->unit = unit_of(d);
    while (count < most) {
        on->objects[count] = scene_object(d, in, on->objects, count);
        count += is_valid(&any_ray, &on->objects[count]);
    }
    set_stage(on, (size_t)count);
}

LOOP_TEST(test_visible, KINDS)
{
    enum { SCENES = 30, RAYS = 24 };
    static stage on;
    tally sum = {0};
    for (uint64_t scene = 0; scene < SCENES; scene += share()) {
        rng d = rng_of(SEED, (uint64_t)_i, 107, scene);
        setting in = {.kind = _i};
        make_scene(&d, &in, &on);
        for (int i = 0; i < RAYS; i++) {
            sure_ray ray = scene_ray(&d, &on, &in);
            if (is_valid(&ray, &on.objects[0]))
                check_ray(&on, &d, &ray, &sum);
        }
        free_stage(&on);
    }
    printf("visible %d: %d rays, %d hits, %d ties, %d left and met, %d lit, %d shaded\n", _i,
           sum.rays, sum.hits, sum.ties, sum.left, sum.lit, sum.shaded);
    ck_assert_int_gt(sum.hits, sum.rays / 8);
    ck_assert_int_gt(sum.left + sum.shaded, sum.hits / 32);
    if (_i == COPIES || _i == DISTANT)
        ck_assert_int_gt(sum.ties, sum.hits / 2);
}

/* Built anywhere, each object is in the boxes above it, by exact
 * arithmetic. */
LOOP_TEST(test_build_anywhere, 4)
{
    enum { COUNT = 60 };
    member *const makers[] = {wild_member, doubling_member, regime_member, endless_member};
    sure_object *objects = make_all(makers[_i], COUNT);
    for (int e = 0; e < SURROUNDINGS_ALL; e++) {
        sure_bvh bvh;
        bool built;
        IN(e, built = bvh_build(objects, COUNT, 1, &bvh));
        ck_assert(built);
        inspect(&(inspection){.objects = objects, .count = COUNT, .bvh = &bvh, .exactly = true});
        bvh_free(&bvh);
    }
    free(objects);
}

LOOP_TEST(test_build, COLLECTIONS)
{
    const size_t count = collections[_i].count;
    const char *name = collections[_i].name;
    sure_object *objects = make_all(collections[_i].make, count);
    sure_bvh first, other;
    ck_assert(bvh_build(objects, count, 1, &first));
    inspection of = {objects, count, &first, .widest = collections[_i].widest};
    inspect(&of);
    printf("%s: %zu objects, %u nodes, %u deep\n", name, count, of.nodes, of.deepest);
    ck_assert_uint_le(of.nodes, count + 1);
    ck_assert_uint_eq(bvh_bytes(&first, count),
                      of.nodes * sizeof *first.nodes + count * sizeof *first.slots);
    for (int threads = 0; threads <= 8; threads++) {
        ck_assert(bvh_build(objects, count, threads, &other));
        ck_assert_msg(same_hierarchy(&first, &other, count, of.nodes), "%s: %d threads", name,
                      threads);
        bvh_free(&other);
        ck_assert(!other.nodes && !other.slots && other.unbounded == 0);
    }
    bvh_free(&first);
    free(objects);
}

/* Of all regimes, of any numbers, and two numbers that are flushed both. */
LOOP_TEST(test_box, SURE_SHAPES)
{
    const double most = 0x0.fffffffffffffp-1022;
    const sure_vec3 at = {most, -most, 0}, axis = {1, 2, 3};
    const sure_object small = object_made((sure_shape)_i, at, axis, axis, most);
    int tried = 0;
    check_box(&small);
    for (case_walk w = walk_regimes((sure_shape)_i, SEED, 30); walk_next(&w);) {
        if (w.index % share() == 0 && is_valid(&any_ray, &w.asked.object))
            check_box(&w.asked.object);
    }
    for (uint64_t i = 0; i < 1500; i += share()) {
        rng d = rng_of(SEED, (uint64_t)_i, 100, i);
        sure_object object = wild_object(&d, (sure_shape)_i);
        if (!is_valid(&any_ray, &object))
            continue;
        check_box(&object);
        tried++;
    }
    ck_assert_int_gt(tried, (int)(750 / share()));
}

/* In all regimes; and where objects touch their boxes. */
LOOP_TEST(test_hits, SURE_SHAPES)
{
    enum { CASES = 20000 };
    int hits = 0, touched = 0;
    for (case_walk w = walk_regimes((sure_shape)_i, SEED, 200); walk_next(&w);) {
        if (w.index % share() == 0 && case_is_valid(&w.asked))
            hits += check_hits(&w.asked, w.index);
    }
    for (uint64_t i = 0; i < CASES && _i != SURE_SHAPE_PLANE; i += share()) {
        sure_case c = touching_case((sure_shape)_i, i);
        touched += case_is_valid(&c) ? check_hits(&c, i) : 0;
    }
    printf("hits %d: %d, %d at boxes\n", _i, hits, touched);
    ck_assert(_i == SURE_SHAPE_PLANE || hits > (int)(700 / share()));
    ck_assert(_i == SURE_SHAPE_PLANE || touched > (int)(CASES / 8 / share()));
}

SUITE("bvh")
