/* SPDX-License-Identifier: MIT */
#include "crowd.h"

#include "../referee/margin.h"

#include "../../numbers/sums.h"
#include "../../support/openmp.h"

#include <surehit/hit_order.h>
#include <surehit/reflect.h>
#include <surehit/spawn.h>

#include <math.h>
#include <stdlib.h>

/* A crowd goes so many steps. */
enum { CROWD_STEPS = 1 << 16 };

/* The streams of walks have nothing in common with the cases', and none ever changes. */
#define WALK_STREAM 28
#define REGIME(NAME, name, key, of)                                                                \
    _Static_assert(key < WALK_STREAM || key >= WALK_STREAM + WALK_KINDS, "a key of walks");
#include "../../cases/regimes.def"
#undef REGIME

/* Two points that a rounded hit and its neighbours may be are at most so many times apart what the
 * largest coordinate is rounded by: each of three coordinates is SURE_SPAWN_STEPS doubles and a
 * half away, and no more than twice the largest of the solid. */
#define ROUNDED (4 * (SURE_SPAWN_STEPS + 0.5))

enum { AT_BOUNDARY = SURE_SIDE_INSIDE + 1 }; /* besides a sure_side */

#define NAME(FAULT, name) name,
const char *walk_fault_name(int which)
{
    static const char *const names[] = {EACH_WALK_FAULT(NAME)};
    return names[which];
}
#undef NAME

/* Beginning and ending. */

static void begin(crowd *all, walker *w)
{
    w->in = setting_of(all->shape, all->kind, &w->g);
    w->ray = (sure_ray){w->in.start, rng_unit(&w->g), 0, INFINITY};
    w->last.met = -1;
}

static void end(crowd *all, walker *w, walk_fault of)
{
    if (all->sum.faults[of]++ == 0)
        all->sum.first[of] = w->last;
    begin(all, w);
}

/* Where it starts. */

/* A line that meets the solid in both directions comes from its inside. */
static int side_of(const case_answer *ahead, sure_status behind)
{
    if (ahead->status != SURE_HIT || behind != SURE_HIT)
        return SURE_SIDE_OUTSIDE;
    return ahead->t == 0 ? AT_BOUNDARY : SURE_SIDE_INSIDE;
}

/* Is the start farther from the solid's boundary than roundings lead? That it is there is what a
 * false hit would say. */
static bool is_off(const walker *w, int solid)
{
    sure_case question = case_of(w, solid, w->ray.direction);
    const reply given = {.status = SURE_HIT};
    question.ray.t_max = 0;
    double by = ROUNDED * margin_length(&question, MARGIN_ULPS, PRECISION_DOUBLE);
    return margin_beyond_length(&question, FAULT_FALSE_HIT, &given, by);
}

/* Is the start where it should be? Else the walk ends. */
static bool judge_start(crowd *all, walker *w)
{
    int met = w->last.met;
    bool past = false, wrong = false;
    for (int i = 0; i < w->in.count; i++) {
        int side = side_of(&w->ahead[i], w->behind[i]);
        if (i == met || met < 0)
            wrong |= met < 0 ? i == 0 && side != SURE_SIDE_INSIDE : side != w->side[i];
        else
            past |= side != w->side[i] && is_off(w, i);
        w->side[i] = side;
    }
    if (wrong && met < 0)
        begin(all, w);
    else if (met < 0)
        all->sum.walks++;
    else if (wrong || past)
        end(all, w, wrong ? WALK_SIDE : WALK_PAST);
    return !wrong && !past;
}

static bool is_sure(const walk_routine *by)
{
    return !by->asked && by->tier >= SURE_TIER_CERTAIN;
}

/* -1, 0 or 1, by the routine. */
static int order(const walk_routine *by, const walker *w, int i, int k)
{
    if (is_sure(by))
        return sure_hit_order(&w->ray, &w->in.solids[i], &w->hits[i], &w->in.solids[k],
                              &w->hits[k]);
    return (w->hits[i].t > w->hits[k].t) - (w->hits[i].t < w->hits[k].t);
}

/* The solid that is met; -1: none. */
static int nearest_of(const walk_routine *by, const walker *w)
{
    int found = -1;
    for (int i = 0; i < w->in.count; i++) {
        if (w->answered[i] == SURE_HIT && (found < 0 || order(by, w, i, found) < 0))
            found = i;
    }
    return found;
}

/* The step. */

/* How far it is to the first boundary in truth. */
static double true_way(const walker *w)
{
    double t = INFINITY;
    for (int i = 0; i < w->in.count; i++) {
        if (w->ahead[i].status == SURE_HIT)
            t = fmin(t, w->ahead[i].t);
    }
    return t * sqrt(dot(w->ray.direction, w->ray.direction));
}

/* Of a whole step: LOST, GHOST, or FAULTS where the answers are right. */
static walk_fault judge_answers(const walker *w)
{
    for (int i = 0; i < w->in.count; i++) {
        if (w->answered[i] != w->ahead[i].status)
            return w->answered[i] == SURE_HIT ? WALK_GHOST : WALK_LOST;
    }
    return WALK_FAULTS;
}

static walk_fault judge_way(const walker *w, int met, sure_vec3 point)
{
    sure_vec3 moved = difference_of(point, w->ray.origin);
    const sure_case question = case_of(w, met, w->ray.direction);
    double way = true_way(w), went = sqrt(dot(moved, moved));
    double by = ROUNDED * margin_length(&question, MARGIN_ULPS, PRECISION_DOUBLE);
    if (fabs(went - way) <= by)
        return WALK_FAULTS;
    return !(went >= way / 2) ? WALK_ZERO : !(went <= 2 * way) ? WALK_PAST : WALK_FAULTS;
}

static sure_vec3 unit(sure_vec3 v)
{
    return scaled(1 / sqrt(dot(v, v)), v);
}

/* Away from the surface, nearly in its plane. */
static sure_vec3 random_grazing(sure_vec3 normal, rng *g)
{
    sure_vec3 along = unit(cross_of(normal, rng_unit(g)));
    return unit(sum_of(along, rng_magnitude(g, -40, -2), normal));
}

static sure_vec3 random_away(sure_vec3 normal, rng *g)
{
    sure_vec3 any = rng_unit(g);
    return dot(any, normal) < 0 ? negate(any) : any;
}

/* Straight on, where it passes; mirrored; or scattered about the normal to its side. */
static sure_vec3 next_direction(walk_kind kind, sure_vec3 d, sure_vec3 normal, bool passes, rng *g)
{
    if (passes)
        return d;
    if (kind == WALK_GRAZING)
        return random_grazing(normal, g);
    return rng_chance(g, 1, 2) ? sure_reflect_textbook(negate(d), normal) : random_away(normal, g);
}

/* Where it says that the hit is, and where it starts again. False: there is no such point. */
static bool start_again(const walk_routine *by, const walker *w, int met, sure_side side,
                        sure_vec3 direction, sure_vec3 *point, sure_vec3 *start)
{
    *point = sum_of(w->ray.origin, w->hits[met].t, w->ray.direction);
    *start = sum_of(*point, by->nudge, direction);
    if (!isnan(by->nudge))
        return true;
    bool found = sure_spawn(&w->ray, &w->in.solids[met], &w->hits[met], side, start);
    *point = *start;
    return found;
}

/* Elsewhere there is mostly nothing beyond. */
static bool often_passed(walk_kind kind, const walker *w, int met)
{
    return w->in.count > 1 && (met > 0 || kind == WALK_BESIDE);
}

/* Nobody is to blame. */
static void stop(crowd *all, walker *w)
{
    all->sum.stopped++;
    begin(all, w);
}

/* Goes to the solid that is met, in or out or back. */
static void go_on(crowd *all, walker *w, int met)
{
    int from = w->side[met];
    bool passes = rng_chance(&w->g, 1, often_passed(all->kind, w, met) ? 2 : 8);
    sure_side to = passes == (from == SURE_SIDE_INSIDE) ? SURE_SIDE_OUTSIDE : SURE_SIDE_INSIDE;
    sure_vec3 normal = w->ahead[met].normal, point, start;
    normal = to == SURE_SIDE_INSIDE ? negate(normal) : normal;
    sure_vec3 d = next_direction(all->kind, w->ray.direction, normal, passes, &w->g);
    if (!start_again(all->by, w, met, to, d, &point, &start)) {
        stop(all, w);
        return;
    }
    w->last = (walk_step){w->in, w->ray, met, start};
    walk_fault found = judge_way(w, met, point);
    if (found != WALK_FAULTS) {
        end(all, w, found);
        return;
    }
    w->side[met] = (int)to;
    w->ray = (sure_ray){start, d, 0, INFINITY};
}

static void take_step(crowd *all, walker *w)
{
    int met = nearest_of(all->by, w);
    walk_fault found = judge_answers(w);
    all->sum.steps++;
    if (found != WALK_FAULTS) {
        w->last = (walk_step){w->in, w->ray, met, w->ray.origin};
        end(all, w, found);
    } else if (met < 0) {
        begin(all, w); /* there is nothing ahead */
    } else {
        go_on(all, w, met);
    }
}

/* A step of each, unless its walk has just ended. */
static bool step_crowd(crowd *all)
{
    if (!ask_truth(all))
        return false;
    ask_routine(all);
    for (int i = 0; i < CROWD; i++) {
        walker *w = &all->walkers[i];
        if (!judge_start(all, w))
            continue;
        if (w->is_asked)
            take_step(all, w);
        else
            stop(all, w);
    }
    return true;
}

static bool walk_crowd(crowd *all, uint64_t seed, uint64_t index, uint64_t steps)
{
    for (int i = 0; i < CROWD; i++) {
        walker *w = &all->walkers[i];
        w->g = rng_of(seed, all->shape, WALK_STREAM + (uint64_t)all->kind,
                      index * CROWD + (uint64_t)i);
        begin(all, w);
    }
    while (all->sum.steps < steps && all->sum.stopped < steps) {
        if (!step_crowd(all))
            return false;
    }
    return true;
}

void walk_add(walk_sum *sum, const walk_sum *of)
{
    sum->steps += of->steps;
    sum->walks += of->walks;
    sum->stopped += of->stopped;
    for (int i = 0; i < WALK_FAULTS; i++) {
        if (sum->faults[i] == 0)
            sum->first[i] = of->first[i];
        sum->faults[i] += of->faults[i];
    }
}

bool walk_steps(const walk_plan *plan, truth *known, sure_shape shape, walk_kind kind,
                walk_sum *sum, char *message)
{
    uint64_t crowds = plan->steps / CROWD_STEPS + (plan->steps % CROWD_STEPS > 0);
    bool one = plan->by.asked || known->programs[0]; /* a process for all */
    bool done = true;
    int threads = one ? 1 : openmp_threads(plan->threads);
    (void)threads;
    *sum = (walk_sum){0};
    if (plan->by.asked)
        candidate_forgive(plan->by.asked);
    OPENMP(omp parallel for ordered schedule(dynamic) num_threads(threads))
    for (uint64_t i = 0; i < crowds; i++) {
        uint64_t left = plan->steps - i * CROWD_STEPS;
        crowd *all = calloc(1, sizeof *all);
        if (all)
            *all = (crowd){.by = &plan->by, .known = known, .shape = shape, .kind = kind};
        bool walked =
            all && walk_crowd(all, plan->seed, i, left < CROWD_STEPS ? left : CROWD_STEPS);
        OPENMP(omp ordered)
        {
            progress_step(plan->bar, (int64_t)(left < CROWD_STEPS ? left : CROWD_STEPS));
            if (walked)
                walk_add(sum, &all->sum);
            else
                done = complain(message, "%s", all ? all->message : "no memory");
            free(all);
        }
    }
    return done;
}
