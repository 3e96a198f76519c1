/* SPDX-License-Identifier: MIT */
/* What shapes compute in double-doubles (src/stages/close.h) is compiled twice: where a processor
 * multiplies and adds in one, exact products are made of that. The last bit is the same, where
 * nothing over- or underflows: in the range that the first stage takes. */
#include "../shapes/filters.h"
#include "../support/every_case.h"

#include "../../src/shapes/cone/cone_filter.h"
#include "../../src/shapes/cylinder/cylinder_filter.h"
#include "../../src/stages/close.h"
#include "../../src/stages/rows.h"

enum { CASES = 400, SEED = 41 };

/* Of one case what a row's functions tell: no hole, so that bytes are compared. */
typedef struct {
    two_terms_dd discriminant;
    sure_hit hits[2]; /* T_CERTAIN, T_EXACT */
    filter_interval chord;
    double step, step_error;
    sure_vec3 origins[2];
    sure_hit nearer[2];
    int64_t verdicts[3], certain, spawned[2];
} told;

/* Of a shape that has an axis. */
static bool terms_of(const sure_case *c, axial_terms *terms)
{
    const sure_shape shape = c->object.shape;
    if (shape == SURE_SHAPE_CYLINDER)
        *terms = cylinder_terms_of(&c->ray, &c->object.as.cylinder);
    if (shape == SURE_SHAPE_CONE)
        *terms = cone_terms_of(&c->ray, &c->object.as.cone);
    return shape == SURE_SHAPE_CYLINDER || shape == SURE_SHAPE_CONE;
}

static void ask_chord(const close_row *row, const sure_case *c, told *all)
{
    axial_terms terms;
    known_discriminant known;
    const filter_subject *of = &filter_subjects[c->object.shape];
    if (terms_of(c, &terms) &&
        discriminant_of(row_of(&c->object), &c->ray, &c->object.as, terms.measure, of->bound,
                        &known) &&
        known.value >= 0)
        all->verdicts[2] = row->filter(&c->ray, &c->object.as, &terms, &known, &all->chord);
}

/* From an end that the first stage knows. */
static void ask_step(const close_row *row, const sure_case *c, told *all)
{
    filter_interval found;
    const void *shape = &c->object.as;
    if (row_of(&c->object)->filter(&c->ray, shape, &found) != FILTER_INTERVAL ||
        !isfinite(found.leave.t))
        return;
    polish_step way = row->step(&c->ray, shape, found.leave.end, found.leave.t);
    all->step = way.step;
    all->step_error = way.error;
    all->certain = way.certain;
}

static void ask_spawn(const close_row *row, const sure_case *c, told *all)
{
    sure_hit hit;
    if (sure_object_hit(&c->ray, &c->object, SURE_TIER_CERTAIN, &hit) != SURE_HIT)
        return;
    for (int side = 0; side < 2; side++)
        all->spawned[side] = row->spawn(&c->ray, &c->object.as, &hit, side ? -1 : 1,
                                        &all->origins[side], &all->nearer[side]);
}

static told ask(const close_row *row, const sure_case *c)
{
    told all;
    memset(&all, 0, sizeof all);
    if (row->discriminant)
        all.discriminant = row->discriminant(&c->ray, &c->object.as);
    for (int i = 0; i < 2 && row->refine_hit; i++)
        all.verdicts[i] =
            row->refine_hit(&c->ray, &c->object.as, i ? T_EXACT : T_CERTAIN, &all.hits[i]);
    ask_chord(row, c, &all);
    ask_step(row, c, &all);
    ask_spawn(row, c, &all);
    return all;
}

SHAPE_TEST(test_fused)
{
    long asked = 0, spawned = 0;
    if (!__builtin_cpu_supports("fma"))
        exit(77);
    for (case_walk w = walk_regimes((sure_shape)_i, SEED, CASES); walk_next(&w);) {
        if (!case_is_valid(&w.asked) || (filter_subjects[_i].body && !filter_fits(&w.asked)))
            continue;
        const told one = ask(&close_rows[_i], &w.asked), two = ask(&close_rows_fused[_i], &w.asked);
        case_require(&w.asked, memcmp(&one, &two, sizeof one) == 0, "another answer with FMA");
        spawned += one.spawned[0] + one.spawned[1];
        asked++;
    }
    ck_assert_int_gt(asked, 4 * CASES);
    ck_assert_int_gt(spawned, CASES);
}

SUITE("close")
