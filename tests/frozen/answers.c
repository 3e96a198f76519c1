#include "answers.h"

#include "fnv.h"

#include <surehit/hit_order.h>
#include <surehit/spawn.h>

#include <math.h>
#include <string.h>

const char *column_name(column which)
{
    static const char *const names[COLUMNS] = {"case",     "certain", "exact", "normal", "interval",
                                               "occluded", "order",   "spawn", "origin"};
    return names[which];
}

answers answers_none(FILE *text)
{
    answers sum = {.text = text};
    for (int i = 0; i < COLUMNS; i++)
        sum.digests[i] = FNV_START;
    return sum;
}

/* Names, not numbers, of members of enums: those may be numbered anew. */
static void add_name(answers *sum, column which, const char *name)
{
    sum->digests[which] = fnv_add(sum->digests[which], name, strlen(name) + 1);
    if (sum->text)
        fprintf(sum->text, " %s", name);
}

static void add_double(answers *sum, column which, double x)
{
    sum->digests[which] = fnv_add(sum->digests[which], &x, sizeof x);
    if (sum->text)
        fprintf(sum->text, " %a", x);
}

static void add_vector(answers *sum, column which, sure_vec3 v)
{
    add_double(sum, which, v.x);
    add_double(sum, which, v.y);
    add_double(sum, which, v.z);
}

static void begin(answers *sum, column which)
{
    sum->counts[which]++;
    if (sum->text)
        fprintf(sum->text, " %s:", column_name(which));
}

static void add_case(answers *sum, const sure_case *question)
{
    double numbers[CASE_NUMBERS_MAX];
    int count = case_numbers(question->object.shape);
    case_to_numbers(question, numbers);
    begin(sum, COLUMN_CASE);
    add_name(sum, COLUMN_CASE, sure_shape_name(question->object.shape));
    for (int i = 0; i < count; i++)
        add_double(sum, COLUMN_CASE, numbers[i]);
}

static void add_certain(answers *sum, const sure_case *question)
{
    const sure_ray *ray = &question->ray;
    const sure_object *object = &question->object;
    sure_hit hit;
    sure_interval interval;
    begin(sum, COLUMN_CERTAIN);
    add_name(sum, COLUMN_CERTAIN, sure_field_name(sure_object_check(ray, object)));
    sure_status status = sure_object_hit(ray, object, SURE_TIER_CERTAIN, &hit);
    add_name(sum, COLUMN_CERTAIN, sure_status_name(status));
    if (status == SURE_HIT)
        add_name(sum, COLUMN_CERTAIN, sure_part_name(hit.part));
    status = sure_object_occluded(ray, object, SURE_TIER_CERTAIN);
    add_name(sum, COLUMN_CERTAIN, sure_status_name(status));
    status = sure_object_interval(ray, object, SURE_TIER_CERTAIN, &interval);
    add_name(sum, COLUMN_CERTAIN, sure_status_name(status));
    if (status == SURE_HIT) {
        add_name(sum, COLUMN_CERTAIN, sure_part_name(interval.enter_part));
        add_name(sum, COLUMN_CERTAIN, sure_part_name(interval.leave_part));
    }
}

static void add_exact(answers *sum, const sure_case *question)
{
    const sure_ray *ray = &question->ray;
    const sure_object *object = &question->object;
    sure_hit hit;
    begin(sum, COLUMN_EXACT);
    sure_status status = sure_object_hit(ray, object, SURE_TIER_EXACT, &hit);
    add_name(sum, COLUMN_EXACT, sure_status_name(status));
    if (status == SURE_HIT) {
        add_double(sum, COLUMN_EXACT, hit.t);
        add_double(sum, COLUMN_EXACT, hit.t_error);
        add_name(sum, COLUMN_EXACT, sure_part_name(hit.part));
        begin(sum, COLUMN_NORMAL);
        add_vector(sum, COLUMN_NORMAL, sure_object_normal(ray, object, SURE_TIER_EXACT, &hit));
    }
    begin(sum, COLUMN_OCCLUDED);
    status = sure_object_occluded(ray, object, SURE_TIER_EXACT);
    add_name(sum, COLUMN_OCCLUDED, sure_status_name(status));
}

static void add_interval(answers *sum, const sure_case *question)
{
    sure_interval interval;
    begin(sum, COLUMN_INTERVAL);
    sure_status status =
        sure_object_interval(&question->ray, &question->object, SURE_TIER_EXACT, &interval);
    add_name(sum, COLUMN_INTERVAL, sure_status_name(status));
    if (status == SURE_HIT) {
        add_double(sum, COLUMN_INTERVAL, interval.t_enter);
        add_double(sum, COLUMN_INTERVAL, interval.t_leave);
        add_name(sum, COLUMN_INTERVAL, sure_part_name(interval.enter_part));
        add_name(sum, COLUMN_INTERVAL, sure_part_name(interval.leave_part));
    }
}

/* The object with the last bit of one of its numbers changed. */
static sure_object neighbour(const sure_case *question, uint64_t index)
{
    enum { RAY = 8 };
    sure_shape shape = question->object.shape;
    double numbers[CASE_NUMBERS_MAX];
    uint64_t bits, fields = (uint64_t)case_numbers(shape) - RAY;
    case_to_numbers(question, numbers);
    memcpy(&bits, &numbers[RAY + index % fields], sizeof bits);
    bits ^= 1;
    memcpy(&numbers[RAY + index % fields], &bits, sizeof bits);
    return case_from_numbers(shape, numbers).object;
}

/* What a ray hits, by both tiers whose hits order and spawn take. */
enum { BY_CERTAIN, BY_EXACT, TIERS_TAKEN };

typedef struct {
    const sure_object *object;
    sure_hit hits[TIERS_TAKEN];
} target;

/* Returns whether the ray hits the object. */
static bool aim(const sure_ray *ray, const sure_object *object, target *at)
{
    at->object = object;
    return sure_object_hit(ray, object, SURE_TIER_CERTAIN, &at->hits[BY_CERTAIN]) == SURE_HIT &&
           sure_object_hit(ray, object, SURE_TIER_EXACT, &at->hits[BY_EXACT]) == SURE_HIT;
}

static void add_order(answers *sum, const sure_ray *ray, const target *first, const target *second)
{
    static const char *const names[] = {"first", "tie", "second"};
    int orders[TIERS_TAKEN];
    for (int i = 0; i < TIERS_TAKEN; i++)
        orders[i] =
            sure_hit_order(ray, first->object, &first->hits[i], second->object, &second->hits[i]);
    begin(sum, COLUMN_ORDER);
    add_name(sum, COLUMN_ORDER, names[orders[BY_CERTAIN] + 1]);
    if (orders[BY_EXACT] != orders[BY_CERTAIN])
        add_name(sum, COLUMN_ORDER, "by exact other");
}

static void add_order_to(answers *sum, const sure_ray *ray, const target *first,
                         const sure_object *object)
{
    target second;
    if (aim(ray, object, &second))
        add_order(sum, ray, first, &second);
}

static void add_spawn(answers *sum, const sure_ray *ray, const target *at, sure_side side)
{
    static const char *const names[2][2] = {{"outside none", "outside"}, {"inside none", "inside"}};
    int found[TIERS_TAKEN];
    sure_vec3 origins[TIERS_TAKEN] = {{0, 0, 0}, {0, 0, 0}};
    for (int i = 0; i < TIERS_TAKEN; i++)
        found[i] = sure_spawn(ray, at->object, &at->hits[i], side, &origins[i]);
    add_name(sum, COLUMN_SPAWN, names[side][found[BY_CERTAIN]]);
    if (found[BY_EXACT] != found[BY_CERTAIN])
        add_name(sum, COLUMN_SPAWN, "by exact other");
    if (found[BY_CERTAIN]) {
        begin(sum, COLUMN_ORIGIN);
        add_vector(sum, COLUMN_ORIGIN, origins[BY_CERTAIN]);
    }
    if (memcmp(&origins[BY_EXACT], &origins[BY_CERTAIN], sizeof origins[0]) != 0)
        add_name(sum, COLUMN_ORIGIN, "by exact other");
}

/* Ordered are the case's object and the next case's, itself, and its neighbour. */
void answers_add(answers *sum, sure_shape shape, regime which, uint64_t index)
{
    sure_case question = regime_case(shape, which, ANSWERS_SEED, index);
    const sure_ray *ray = &question.ray;
    target at;
    add_case(sum, &question);
    add_certain(sum, &question);
    add_exact(sum, &question);
    add_interval(sum, &question);
    if (aim(ray, &question.object, &at)) {
        sure_case next = regime_case(shape, which, ANSWERS_SEED, index + 1);
        sure_object close = neighbour(&question, index);
        add_order_to(sum, ray, &at, &next.object);
        add_order(sum, ray, &at, &at);
        add_order_to(sum, ray, &at, &close);
        begin(sum, COLUMN_SPAWN);
        add_spawn(sum, ray, &at, SURE_SIDE_OUTSIDE);
        add_spawn(sum, ray, &at, SURE_SIDE_INSIDE);
    }
    if (sum->text)
        fputc('\n', sum->text);
}
