/* SPDX-License-Identifier: MIT */
#include "answers.h"

#include "fnv.h"

#include "../support/answers.h"
#include "../../src/geometry/coordinate.h"

const char *column_name(column which)
{
    static const char *const names[COLUMNS] = {"case",     "certain", "exact", "normal", "interval",
                                               "occluded", "order",   "spawn", "origin"};
    return names[which];
}

frozen_answers answers_none(FILE *text)
{
    frozen_answers sum = {.text = text};
    for (int i = 0; i < COLUMNS; i++)
        sum.digests[i] = FNV_START;
    return sum;
}

/* Names, not numbers, of members of enums: those may be numbered anew. */
static void add_name(frozen_answers *sum, column which, const char *name)
{
    sum->digests[which] = fnv_add(sum->digests[which], name, strlen(name) + 1);
    if (sum->text)
        fprintf(sum->text, " %s", name);
}

static void add_double(frozen_answers *sum, column which, double x)
{
    sum->digests[which] = fnv_add(sum->digests[which], &x, sizeof x);
    if (sum->text)
        fprintf(sum->text, " %a", x);
}

static void add_vector(frozen_answers *sum, column which, sure_vec3 v)
{
    for (int i = 0; i < 3; i++)
        add_double(sum, which, coordinate(v, i));
}

static void begin(frozen_answers *sum, column which)
{
    sum->counts[which]++;
    if (sum->text)
        fprintf(sum->text, " %s:", column_name(which));
}

static void add_case(frozen_answers *sum, const sure_case *question)
{
    double numbers[CASE_NUMBERS_MAX];
    int count = case_numbers(question->object.shape);
    case_to_numbers(question, numbers);
    begin(sum, COLUMN_CASE);
    add_name(sum, COLUMN_CASE, sure_shape_name(question->object.shape));
    for (int i = 0; i < count; i++)
        add_double(sum, COLUMN_CASE, numbers[i]);
}

static void add_status(frozen_answers *sum, column which, int status)
{
    add_name(sum, which, sure_status_name((sure_status)status));
}

static void add_parts(frozen_answers *sum, column which, const sure_interval *interval)
{
    add_name(sum, which, sure_part_name(interval->enter_part));
    add_name(sum, which, sure_part_name(interval->leave_part));
}

static void add_certain(frozen_answers *sum, const sure_case *question, const answers *certain)
{
    sure_field field = sure_object_check(&question->ray, &question->object);
    begin(sum, COLUMN_CERTAIN);
    add_name(sum, COLUMN_CERTAIN, sure_field_name(field));
    add_status(sum, COLUMN_CERTAIN, certain->status);
    if (certain->status == SURE_HIT)
        add_name(sum, COLUMN_CERTAIN, sure_part_name(certain->hit.part));
    add_status(sum, COLUMN_CERTAIN, certain->occluded);
    add_status(sum, COLUMN_CERTAIN, certain->interval_status);
    if (certain->interval_status == SURE_HIT)
        add_parts(sum, COLUMN_CERTAIN, &certain->interval);
}

static void add_exact(frozen_answers *sum, const answers *exact)
{
    begin(sum, COLUMN_EXACT);
    add_status(sum, COLUMN_EXACT, exact->status);
    if (exact->status == SURE_HIT) {
        add_double(sum, COLUMN_EXACT, exact->hit.t);
        add_double(sum, COLUMN_EXACT, exact->hit.t_error);
        add_name(sum, COLUMN_EXACT, sure_part_name(exact->hit.part));
        begin(sum, COLUMN_NORMAL);
        add_vector(sum, COLUMN_NORMAL, exact->normal);
    }
    begin(sum, COLUMN_OCCLUDED);
    add_status(sum, COLUMN_OCCLUDED, exact->occluded);
    begin(sum, COLUMN_INTERVAL);
    add_status(sum, COLUMN_INTERVAL, exact->interval_status);
    if (exact->interval_status == SURE_HIT) {
        add_double(sum, COLUMN_INTERVAL, exact->interval.t_enter);
        add_double(sum, COLUMN_INTERVAL, exact->interval.t_leave);
        add_parts(sum, COLUMN_INTERVAL, &exact->interval);
    }
}

/* The object with the last bit of one of its numbers changed. */
static sure_object neighbour(const sure_case *question, uint64_t index)
{
    sure_case close = *question;
    uint64_t bits, fields = (uint64_t)case_numbers(question->object.shape) - AT_OBJECT;
    double *number = case_number(&close, AT_OBJECT + (int)(index % fields));
    memcpy(&bits, number, sizeof bits);
    bits ^= 1;
    memcpy(number, &bits, sizeof bits);
    return close.object;
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

static void add_order(frozen_answers *sum, const sure_ray *ray, const target *first,
                      const target *second)
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

static void add_order_to(frozen_answers *sum, const sure_ray *ray, const target *first,
                         const sure_object *object)
{
    target second;
    if (aim(ray, object, &second))
        add_order(sum, ray, first, &second);
}

static void add_spawn(frozen_answers *sum, const answers *certain, const answers *exact, int side)
{
    static const char *const names[2][2] = {{"outside none", "outside"}, {"inside none", "inside"}};
    add_name(sum, COLUMN_SPAWN, names[side][certain->found[side]]);
    if (exact->found[side] != certain->found[side])
        add_name(sum, COLUMN_SPAWN, "by exact other");
    if (certain->found[side]) {
        begin(sum, COLUMN_ORIGIN);
        add_vector(sum, COLUMN_ORIGIN, certain->origin[side]);
    }
    if (memcmp(&exact->origin[side], &certain->origin[side], sizeof exact->origin[side]) != 0)
        add_name(sum, COLUMN_ORIGIN, "by exact other");
}

/* Ordered are the case's object and the next case's, itself, and its neighbour. */
void answers_add(frozen_answers *sum, sure_shape shape, regime which, uint64_t index)
{
    sure_case question = regime_case(shape, which, ANSWERS_SEED, index);
    const sure_ray *ray = &question.ray;
    answers certain = answers_of(&question, SURE_TIER_CERTAIN, NULL);
    answers exact = answers_of(&question, SURE_TIER_EXACT, NULL);
    add_case(sum, &question);
    add_certain(sum, &question, &certain);
    add_exact(sum, &exact);
    if (certain.status == SURE_HIT && exact.status == SURE_HIT) {
        target at = {&question.object, {certain.hit, exact.hit}};
        sure_case next = regime_case(shape, which, ANSWERS_SEED, index + 1);
        sure_object close = neighbour(&question, index);
        add_order_to(sum, ray, &at, &next.object);
        add_order(sum, ray, &at, &at);
        add_order_to(sum, ray, &at, &close);
        begin(sum, COLUMN_SPAWN);
        for (int side = 0; side < SIDES; side++)
            add_spawn(sum, &certain, &exact, side);
    }
    if (sum->text)
        fputc('\n', sum->text);
}
