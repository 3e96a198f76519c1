/* SPDX-License-Identifier: MIT */
/* The referee's parts: moved objects and margins, events, entry conditions. */
#include "moved.h"
#include "referee.h"
#include "regimes.h"
#include "suite.h"

#include <float.h>

/* Questions whose answer is wrong by a known length, by the shape's equation. */
typedef struct {
    const char *line; /* of the case */
    fault which;
    const char *said; /* the part, of a wrong one */
    double length;
} known_margin;

static const known_margin known[] = {
    /* Past the sphere, through it, short of it, and short of its far side. */
    {"sphere 1.25 -4 0 0 1 0 0 inf 0 0 0 1", FAULT_FALSE_HIT, NULL, 0.25},
    {"sphere 0.75 -4 0 0 1 0 0 inf 0 0 0 1", FAULT_FALSE_MISS, NULL, 0.25},
    {"sphere -4 0 0 1 0 0 0 2.5 0 0 0 1", FAULT_FALSE_HIT, NULL, 0.5},
    {"sphere 0 0 0 1 0 0 0 0.5 0 0 0 1", FAULT_FALSE_HIT, NULL, 0.5},
    {"sphere 0 0 0 1 0 0 0 1.5 0 0 0 1", FAULT_FALSE_MISS, NULL, 0.5},
    /* Beside the wall, above the top, and within them. */
    {"cylinder 1.25 -4 1 0 1 0 0 inf 0 0 0 0 0 2 1", FAULT_FALSE_HIT, NULL, 0.25},
    {"cylinder -4 0 2.5 1 0 0 0 inf 0 0 0 0 0 2 1", FAULT_FALSE_HIT, NULL, 0.5},
    {"cylinder -4 0 1.75 1 0 0 0 inf 0 0 0 0 0 2 1", FAULT_FALSE_MISS, NULL, 0.25},
    {"cylinder 0.75 0 4 0 0 -1 0 inf 0 0 0 0 0 2 1", FAULT_WRONG_PART, "wall", 0.25},
    /* A cone with sides of 3, 4 and 5: its wall goes out by 4/5 of the way across. */
    {"cone 3.5 -9 0 0 1 0 0 inf 0 0 0 0 0 4 3", FAULT_FALSE_HIT, NULL, 0.4},
    {"cone -9 0 -0.5 1 0 0 0 inf 0 0 0 0 0 4 3", FAULT_FALSE_HIT, NULL, 0.5},
    {"cone -9 0 4.5 1 0 0 0 inf 0 0 0 0 0 4 3", FAULT_FALSE_HIT, NULL, 0.3},
    {"cone -9 0 0.5 1 0 0 0 inf 0 0 0 0 0 4 3", FAULT_FALSE_MISS, NULL, 0.5},
    {"cone 2 0 -9 0 0 1 0 inf 0 0 0 0 0 4 3", FAULT_WRONG_PART, "wall", 0.5},
    {"box -4 2.25 1 1 0 0 0 inf 0 0 0 2 2 2", FAULT_FALSE_HIT, NULL, 0.25},
    {"box -4 1.75 1 1 0 0 0 inf 0 0 0 2 2 2", FAULT_FALSE_MISS, NULL, 0.25},
    /* Beside the rim, short of the disc, past it by half. */
    {"disc 1.25 0 4 0 0 -1 0 inf 0 0 0 0 0 3 1", FAULT_FALSE_HIT, NULL, 0.25},
    {"disc 0.75 0 4 0 0 -1 0 inf 0 0 0 0 0 3 1", FAULT_FALSE_MISS, NULL, 0.25},
    {"disc 0 0 2 0 0 -1 0 1.5 0 0 0 0 0 3 1", FAULT_FALSE_HIT, NULL, 0.5},
    {"disc 0 0 2 0 0 -1 0 2.5 0 0 0 0 0 3 1", FAULT_FALSE_MISS, NULL, 0.5},
    /* Short of the plane, along it, through it. */
    {"plane 0 0 2 0 0 -1 0 1.5 0 0 0 0 0 3", FAULT_FALSE_HIT, NULL, 0.5},
    {"plane 0 0 0.25 1 0 0 0 4 0 0 0 0 0 3", FAULT_FALSE_HIT, NULL, 0.25},
    {"plane 0 0 0.25 0 0 -1 0 1 0 0 0 0 0 3", FAULT_FALSE_MISS, NULL, 0.25},
    {"plane 0 0 0.25 0 0 1 0 1 0 0 0 0 0 3", FAULT_FALSE_HIT, NULL, 0.25},
};
enum { KNOWN = sizeof known / sizeof *known };

static sure_case case_of(const char *line)
{
    sure_case question;
    ck_assert_msg(case_read(line, &question), "%s", line);
    return question;
}

/* Of a ball of radius 2, 5 away. */
TEST(test_units)
{
    static const struct {
        margin_unit unit;
        precision in;
        double length;
    } rows[] = {{MARGIN_SIZE, PRECISION_DOUBLE, 2},
                {MARGIN_DISTANCE, PRECISION_DOUBLE, 7},
                {MARGIN_LENGTH, PRECISION_DOUBLE, 1},
                {MARGIN_ULPS, PRECISION_DOUBLE, 0x1p-50},
                {MARGIN_ULPS, PRECISION_FLOAT, 0x1p-21}};
    const sure_case ball = case_of("sphere 0 0 0 1 0 0 0 inf 3 4 0 2");
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        ck_double_same(margin_length(&ball, rows[i].unit, rows[i].in), rows[i].length);
}

static reply said(const known_margin *row)
{
    reply given = {.status = row->which == FAULT_FALSE_MISS ? SURE_MISS : SURE_HIT};
    for (int i = 0; i < SURE_PARTS && row->said; i++) {
        if (strcmp(row->said, sure_part_name((sure_part)i)) == 0)
            given.part = i;
    }
    return given;
}

/* A slab whose axis is tilted is made thicker. */
static void expect_margin(const sure_case *question, const known_margin *row)
{
    const reply given = said(row);
    double from = row->length * (1 - 0x1p-12), to = row->length * (1 + 0x1p-20);
    ck_assert_msg(margin_beyond_length(question, row->which, &given, from), "%s", row->line);
    ck_assert_msg(!margin_beyond_length(question, row->which, &given, to), "%s", row->line);
    const movement unit = movement_of_all(1);
    double found = margin_of(question, row->which, &given, row->length / 64, INFINITY, 0, &unit);
    ck_assert_double_ge(found, row->length * (1 - 0x1p-3));
    ck_assert_double_le(found, row->length);
}

LOOP_TEST(test_known_margins, KNOWN)
{
    const sure_case question = case_of(known[_i].line);
    expect_margin(&question, &known[_i]);
}

/* Where doubles end, a margin is found all the same. */
LOOP_TEST(test_least_margins, KNOWN)
{
    const known_margin *row = &known[_i];
    const double scale = 0x1p-1071;
    const movement unit = movement_of_all(scale);
    const reply given = said(row);
    sure_case question = case_of(row->line);
    for (int i = 0; i < case_numbers(question.object.shape); i++) {
        number_kind what = case_number_kind(question.object.shape, i);
        *case_number(&question, i) *= what == IS_LENGTH || what == IS_TIME ? scale : 1;
    }
    double found = margin_of(&question, row->which, &given, 0x1p-3, INFINITY, 0, &unit);
    ck_assert_double_le(found, row->length);
}

TEST(test_largest_margin)
{
    const reply hit = {.status = SURE_HIT};
    const sure_case question = case_of("plane 0 0 0x1.8p+1023 1 0 0 0 inf 0 0 -0x1.8p+1023 0 0 1");
    const movement unit = movement_of_all(0x1p+1022);
    double found = margin_of(&question, FAULT_FALSE_HIT, &hit, 0x1p-1022, INFINITY, 0, &unit);
    ck_assert_double_ge(found, 0.5);
    ck_assert_double_lt(found, 4);
}

/* By what all sizes would have to grow or shrink, about the middle; 0: it is not told. */
static const known_margin grown[] = {
    {"cylinder -9 0 2 1 0 0 0 inf 0 0 0 0 0 1 4", FAULT_FALSE_HIT, NULL, 2},
    {"cylinder 6 0 -9 0 0 1 0 inf 0 0 0 0 0 1 4", FAULT_FALSE_HIT, NULL, 0.5},
    {"cylinder -9 0 0.75 1 0 0 0 inf 0 0 0 0 0 1 4", FAULT_FALSE_MISS, NULL, 0.5},
    {"cone -9 0 -2 1 0 0 0 inf 0 0 0 0 0 4 3", FAULT_FALSE_HIT, NULL, 1},
    {"cone -9 0 5 1 0 0 0 inf 0 0 0 0 0 4 3", FAULT_FALSE_HIT, NULL, 0.5},
    {"cone 4.5 0 -9 0 0 1 0 inf 0 0 0 0 0 4 3", FAULT_FALSE_HIT, NULL, 0.5},
    {"box -9 -2 4 1 0 0 0 inf 0 0 0 2 4 8", FAULT_FALSE_HIT, NULL, 1},
    {"box -9 2 -4 1 0 0 0 inf 0 0 0 2 4 8", FAULT_FALSE_HIT, NULL, 1},
    {"box 2.5 2 -9 0 0 1 0 inf 0 0 0 2 4 8", FAULT_FALSE_HIT, NULL, 0.5},
    {"sphere 2.5 -4 0 0 1 0 0 inf 0 0 0 1", FAULT_FALSE_HIT, NULL, 1.5},
    {"disc 1.25 0 4 0 0 -1 0 inf 0 0 0 0 0 3 1", FAULT_FALSE_HIT, NULL, 0.25},
    {"plane 0 0 2 0 0 -1 0 1.5 0 0 0 0 0 3", FAULT_FALSE_HIT, NULL, 0.25},
    {"box -9 9 9 1 0 0 0 inf 0 0 0 2 2 0", FAULT_FALSE_HIT, NULL, 0},
    {"cylinder -9 0 9 1 0 0 0 inf 0 0 0 0 0 1 0", FAULT_FALSE_HIT, NULL, 0},
};

LOOP_TEST(test_grown, sizeof grown / sizeof *grown)
{
    const known_margin *row = &grown[_i];
    const sure_case question = case_of(row->line);
    const reply given = said(row);
    const movement unit = margin_way(&question, MARGIN_GROWTH, PRECISION_DOUBLE);
    movement way = movement_times(&unit, row->length * (1 - 0x1p-12));
    ck_assert_msg(margin_beyond(&question, row->which, &given, &way) == (row->length > 0), "%s",
                  row->line);
    way = movement_times(&unit, row->length * (1 + 0x1p-12));
    ck_assert_msg(!margin_beyond(&question, row->which, &given, &way), "%s", row->line);
}

/* Turned anyhow and moved by a thousand, a box but moved. */
static sure_vec3 turned(const sure_mat3 *turn, sure_vec3 v)
{
    return sure_rotation_apply_textbook(turn, v);
}

static void turn_at(const sure_mat3 *turn, double *at, double move)
{
    sure_vec3 v = turned(turn, (sure_vec3){at[0], at[1], at[2]});
    at[0] = v.x + move;
    at[1] = v.y + move;
    at[2] = v.z + move;
}

static sure_case turned_case(const char *line, const sure_mat3 *turn, double move)
{
    sure_case question = case_of(line);
    const sure_shape_info *info = sure_shape_info_of(question.object.shape);
    turn_at(turn, case_number(&question, AT_O), move);
    turn_at(turn, case_number(&question, AT_D), 0);
    for (int i = 0; i < info->field_count; i++) {
        sure_kind kind = info->fields[i].kind;
        double *at = case_number(&question, AT_OBJECT + info->fields[i].at);
        if (kind != SURE_KIND_RADIUS)
            turn_at(turn, at, kind == SURE_KIND_NORMAL ? 0 : move);
    }
    return question;
}

LOOP_TEST(test_turned_margins, KNOWN)
{
    static const sure_mat3 still = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    bool is_box = strncmp(known[_i].line, "box", 3) == 0;
    for (uint64_t n = 0; n < 20; n++) {
        sure_vec3 view = suite_doubles(1, n, 0);
        sure_mat3 turn = still;
        if (!is_box)
            ck_assert_int_eq(sure_camera_rotation_textbook(view, &turn), SURE_HIT);
        sure_case question = turned_case(known[_i].line, &turn, 1000 * suite_double(5, n, 0));
        expect_margin(&question, &known[_i]);
    }
}

/* A right decision is right for an object as it is: at no margin it is wrong. Where the way is
 * nothing beside the coordinates, roundings are all there is. */
SHAPE_TEST(test_right_is_never_beyond)
{
    for (int which = 0; which < REGIMES; which++) {
        for (uint64_t i = 0; i < 100 && regime_applies((sure_shape)_i, (regime)which); i++) {
            sure_case question = regime_case((sure_shape)_i, (regime)which, 7, i);
            case_answer right = case_answer_of(&question, SURE_TIER_EXACT);
            reply given = {.status = right.status, .part = (int)right.part};
            bool is_hit = right.status == SURE_HIT;
            double size = margin_length(&question, MARGIN_SIZE, PRECISION_DOUBLE);
            for (int power = -70; power <= 0 && right.status != SURE_INVALID; power += 10) {
                double by = ldexp(size, power);
                fault as = is_hit ? FAULT_FALSE_HIT : FAULT_FALSE_MISS;
                bool part = is_hit && margin_beyond_length(&question, FAULT_WRONG_PART, &given, by);
                ck_assert_msg(!part && !margin_beyond_length(&question, as, &given, by),
                              "%s %s %llu at 2^%d: %d", sure_shape_name((sure_shape)_i),
                              regime_name((regime)which), (unsigned long long)i, power, part);
            }
        }
    }
}

/* -1: the chord is none, in doubles. */
static int is_far_end(const sure_ray *ray, const sure_object *solid, double t)
{
    sure_interval ends;
    ck_assert_int_eq(sure_object_interval(ray, solid, SURE_TIER_EXACT, &ends), SURE_HIT);
    return ends.t_enter == ends.t_leave ? -1 : t == ends.t_leave;
}

/* The hit of a solid whose faces lie a little elsewhere. Returns whether it is the other end, or -1
 * where that can't be told. */
static int other_end(const sure_case *question, const case_answer *right, double by)
{
    const movement how = movement_of_all(by);
    sure_case moved = *question;
    if (!object_moved(&question->object, &how, &moved.object))
        return -1;
    case_answer other = case_answer_of(&moved, SURE_TIER_EXACT);
    ck_assert_int_eq(other.status, SURE_HIT);
    int was = is_far_end(&question->ray, &question->object, right->t);
    int is = is_far_end(&moved.ray, &moved.object, other.t);
    return was < 0 || is < 0 ? -1 : was != is;
}

/* Where no miss is in question, it is told whether the end is. */
SHAPE_TEST(test_ends)
{
    int ends = 0;
    const sure_shape shape = (sure_shape)_i;
    for (int i = 0; i < REGIMES * 100 && sure_shape_info_of(shape)->solid; i++) {
        if (!regime_applies(shape, (regime)(i / 100)))
            continue;
        sure_case question = regime_case(shape, (regime)(i / 100), 9, (uint64_t)i);
        case_answer right = case_answer_of(&question, SURE_TIER_EXACT);
        reply given = {.status = SURE_MISS};
        double by = margin_length(&question, MARGIN_SIZE, PRECISION_DOUBLE) * 1e-3;
        if (right.status != SURE_HIT ||
            !margin_beyond_length(&question, FAULT_FALSE_MISS, &given, by))
            continue;
        int out = other_end(&question, &right, by), in = other_end(&question, &right, -by);
        if (out < 0 || in < 0)
            continue;
        ck_assert_msg((out || in) == margin_of_end(&question, by), "%s %s %d",
                      sure_shape_name(shape), regime_name((regime)(i / 100)), i);
        ends += out || in;
    }
    ck_assert(ends > 0 || !sure_shape_info_of(shape)->solid);
}

TEST(test_events)
{
    static const struct {
        const char *line;
        event is;
    } rows[] = {
        {"sphere 1 -4 0 0 1 0 0 inf 0 0 0 1", EVENT_TOUCH},
        {"sphere 0.5 -4 0 0 1 0 0 inf 0 0 0 1", EVENT_CLEAR},
        {"sphere 1 0 0 1 0 0 0 inf 0 0 0 1", EVENT_SURFACE},
        {"sphere 0 0 0 1 0 0 0 inf 0 0 0 1", EVENT_INSIDE},
        {"sphere 0 0 0 1 0 0 1 inf 0 0 0 1", EVENT_SURFACE},
        {"sphere -4 0 0 1 0 0 0 3 0 0 0 1", EVENT_END},
        {"sphere -4 0 0 1 0 0 0 0x1.8000000000001p+1 0 0 0 1", EVENT_CLEAR},
        {"cylinder 1 -4 1 0 1 0 0 inf 0 0 0 0 0 2 1", EVENT_TOUCH},
        {"cylinder 1 0 -4 0 0 1 0 inf 0 0 0 0 0 2 1", EVENT_TOUCH},
        {"cylinder -4 0 2 1 0 0 0 inf 0 0 0 0 0 2 1", EVENT_TOUCH},
        {"cone -4 0 4 1 0 0 0 inf 0 0 0 0 0 4 3", EVENT_TOUCH},
        {"box -4 2 1 1 0 0 0 inf 0 0 0 2 2 2", EVENT_TOUCH},
        {"disc 1 0 4 0 0 -1 0 inf 0 0 0 0 0 1 1", EVENT_TOUCH},
        {"disc -4 0 0 1 0 0 0 inf 0 0 0 0 0 1 1", EVENT_TOUCH},
        {"disc 0 0 4 0 0 -1 0 inf 0 0 0 0 0 1 1", EVENT_CLEAR},
        {"plane 0 0 4 0 0 -1 0 inf 0 0 0 0 0 1", EVENT_CLEAR},
        {"plane 0 0 4 0 0 -1 0 4 0 0 0 0 0 1", EVENT_END},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const sure_case question = case_of(rows[i].line);
        case_answer truth = case_answer_of(&question, SURE_TIER_EXACT);
        const reply given = {.status = SURE_MISS};
        ck_assert_msg(event_of(&question, &truth, FAULT_FALSE_MISS, &given) == rows[i].is, "%s",
                      rows[i].line);
    }
}

/* Entry conditions. */

static const char *const entries[] = {"unit",
                                      "aligned",
                                      "local",
                                      "centred",
                                      "t_min=0",
                                      "ray",
                                      "line",
                                      "segment",
                                      "outside",
                                      "apart=1e-3",
                                      "scale=0.5..1e3",
                                      "square",
                                      "unit local ray outside",
                                      "centred, segment",
                                      "unit line square"};
enum { ENTRIES = sizeof entries / sizeof *entries };

/* What is received is in the entry, and in typical cases it is the same question. */
LOOP_TEST(test_entries, ENTRIES * 2)
{
    entry all;
    precision in = _i % 2 == 0 ? PRECISION_DOUBLE : PRECISION_FLOAT;
    ck_assert_ptr_null(entry_read(entries[_i / 2], &all));
    int received = 0, asked = 0;
    for (int i = 0; i < SURE_SHAPES * REGIMES; i++) {
        sure_shape shape = (sure_shape)(i / REGIMES);
        for (uint64_t n = 0; n < 20 && regime_applies(shape, (regime)(i % REGIMES)); n++) {
            sure_case question = regime_case(shape, (regime)(i % REGIMES), 3, n), made;
            asked++;
            if (!entry_case(&all, &question, in, &made))
                continue;
            received++;
            ck_assert_msg(entry_holds(&all, &made, in), "%s: %s %s %d", entries[_i / 2],
                          sure_shape_name(shape), regime_name((regime)(i % REGIMES)), (int)n);
        }
    }
    ck_assert_int_gt(received, asked / 20);
}

/* Of what is changed without a change of the geometry. */
LOOP_TEST(test_same_question, 5)
{
    entry all;
    int hits = 0;
    ck_assert_ptr_null(entry_read(entries[_i], &all));
    for (int i = 0; i < SURE_SHAPES * 200; i++) {
        sure_case question =
                      regime_case((sure_shape)(i % SURE_SHAPES), REGIME_TYPICAL, 5, (uint64_t)i),
                  made;
        ck_assert(entry_case(&all, &question, PRECISION_DOUBLE, &made));
        case_answer a = case_answer_of(&question, SURE_TIER_EXACT);
        case_answer b = case_answer_of(&made, SURE_TIER_EXACT);
        double speed = sqrt(question.ray.direction.x * question.ray.direction.x +
                            question.ray.direction.y * question.ray.direction.y +
                            question.ray.direction.z * question.ray.direction.z);
        double t = all.unit ? a.t * speed : all.from_zero ? a.t - question.ray.t_min : a.t;
        ck_assert_int_eq(a.status, b.status);
        hits += a.status == SURE_HIT;
        if (a.status == SURE_HIT) /* typical objects are 2^-10 to 2^10 in size and distance */
            ck_assert_double_le(fabs(b.t - t), 0x1p-20 * (fabs(t) + fabs(a.t)));
    }
    ck_assert_int_gt(hits, 200);
}

TEST(test_words)
{
    static const char *const wrong[] = {"units",     "ray segment", "unit=1",
                                        "scale=1",   "scale=2..1",  "apart=2",
                                        "touch=hit", "unit;local",  "scale=1..2"};
    entry all;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        ck_assert_msg(entry_read(wrong[i], &all) != NULL, "%s", wrong[i]);
    ck_assert_ptr_null(entry_read("", &all));
    ck_assert(!all.declared);
    ck_assert_ptr_null(entry_read(" unit,,touch=miss  apart=1e-6 scale=0.1..10", &all));
    ck_assert(all.declared && all.unit && all.misses[EVENT_TOUCH] && all.outside && !all.local);
    ck_assert(all.apart == 1e-6 && all.least == 0.1 && all.most == 10);
}

/* What has no size is not scaled, but a plane. */
TEST(test_no_size)
{
    entry all;
    sure_case made, point = case_of("sphere 1 -4 0 0 1 0 0 inf 0 0 0 0"),
                    plane = case_of("plane 0 0 4 0 0 -1 0 inf 0 0 0 0 0 1");
    ck_assert_ptr_null(entry_read("scale=0.5..1e3", &all));
    ck_assert(!entry_case(&all, &point, PRECISION_DOUBLE, &made));
    ck_assert(entry_case(&all, &plane, PRECISION_DOUBLE, &made));
}

/* Half of the size off a ball, however far the origin. */
TEST(test_apart)
{
    entry all;
    sure_case made, off = case_of("sphere 100 1.75 0 1 0 0 0 inf 100 0 0 1"),
                    near = case_of("sphere 100 1.375 0 1 0 0 0 inf 100 0 0 1");
    ck_assert_ptr_null(entry_read("apart=0.5", &all));
    ck_assert(entry_case(&all, &off, PRECISION_DOUBLE, &made));
    ck_assert(!entry_case(&all, &near, PRECISION_DOUBLE, &made));
}

/* A wrong decision that a convention explains is allowed, and counted; another one is not. */
TEST(test_conventions)
{
    static const struct {
        const char *line, *words;
        sure_status given;
        double t;
        bool allowed;
    } rows[] = {
        {"sphere 1 -4 0 0 1 0 0 inf 0 0 0 1", "touch=miss", SURE_MISS, 0, true},
        {"sphere 1 -4 0 0 1 0 0 inf 0 0 0 1", "end=miss", SURE_MISS, 0, false},
        {"sphere 0.99 -4 0 0 1 0 0 inf 0 0 0 1", "touch=miss", SURE_MISS, 0, false},
        {"sphere 1.01 -4 0 0 1 0 0 inf 0 0 0 1", "touch=miss", SURE_HIT, 4, false},
        {"sphere 0 0 0 1 0 0 0 inf 0 0 0 1", "inside=miss", SURE_MISS, 0, true},
        {"sphere 0 0 0 1 0 0 0 0.5 0 0 0 1", "inside=0", SURE_HIT, 0, true},
        {"sphere 0 0 0 1 0 0 0 0.5 0 0 0 1", "inside=0", SURE_HIT, 0.25, false},
        {"sphere 1 0 0 1 0 0 0 inf 0 0 0 1", "surface=miss", SURE_MISS, 0, true},
        {"sphere -4 0 0 1 0 0 0 3 0 0 0 1", "end=miss", SURE_MISS, 0, true},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        example one = {.found = true, .question = case_of(rows[i].line)};
        const margins told = margins_of(MARGIN_SIZE);
        refereed sum = {.allowed = {0}};
        entry by;
        one.truth = case_answer_of(&one.question, SURE_TIER_EXACT);
        one.given = (reply){.status = rows[i].given, .t = rows[i].t, .part = REPLY_NO_PART};
        ck_assert_ptr_null(entry_read(rows[i].words, &by));
        unsigned left = referee(&sum, &told, &by, PRECISION_DOUBLE, &one);
        uint64_t allowed = 0, wrong = 0;
        for (int n = 0; n < EVENTS; n++) {
            allowed += sum.allowed[n];
            wrong += sum.events[n];
        }
        ck_assert_msg((left == 0) == rows[i].allowed, "%s %s", rows[i].line, rows[i].words);
        ck_assert_uint_eq(allowed, rows[i].allowed);
        ck_assert_uint_eq(wrong, !rows[i].allowed);
    }
}

SUITE("referee")
