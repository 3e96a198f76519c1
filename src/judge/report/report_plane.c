/* The plane of time and wrong decisions, both by powers of ten: a point a candidate. */
#include "report_parts.h"

#include <math.h>
#include <string.h>

/* The drawing, in its own units; it is as wide as a phone, so its letters are legible there. */
#define WIDTH 360
#define HEIGHT 268
#define LEFT 52
#define RIGHT 350
#define TOP 10
#define BOTTOM 196 /* of the part with powers of ten */
#define NONE 216   /* the line of those who are never wrong */
#define FLOOR 228  /* the time's axis */
#define MEASURE " (the measure)"
#define NEAR 14    /* so near a point its name needs no line, ... */
#define FAR 160    /* ... and so far it may be */
#define ALONE 9    /* so far from the other points it is then */
#define LETTER 6.8 /* the width of one, upwards, by the widest names */
#define LINE 11    /* the height of a name */

typedef struct {
    double x0, y0, x1, y1;
} box;

typedef struct {
    const report_candidate *who;
    report_sum sum;
    double x, y;
    box name;
    bool measure;
    bool led; /* a line leads from the point to its name */
} mark;

typedef struct {
    int low, high; /* powers of ten at the ends */
} decades;

typedef struct {
    decades time, wrong;
    mark marks[REPORT_CANDIDATES];
    int count;
} plane;

static double along(decades of, double number, double from, double to)
{
    return from + (log10(number) - of.low) / (of.high - of.low) * (to - from);
}

static void widen(decades *of, double number)
{
    int below = (int)floor(log10(number)), above = (int)ceil(log10(number));
    if (below < of->low)
        of->low = below;
    if (above > of->high)
        of->high = above;
}

/* The same axes for every shape, so that planes can be compared. */
static void measure_axes(plane *all, const report_candidate *list, int count, report_part part)
{
    all->time = (decades){1, 3};
    all->wrong = (decades){5, 6};
    for (int i = 0; i < count * SURE_SHAPES; i++) {
        report_sum sum = report_sum_of(&list[i / SURE_SHAPES], i % SURE_SHAPES, part);
        if (sum.nanoseconds > 0)
            widen(&all->time, sum.nanoseconds);
        if (sum.share > 0)
            widen(&all->wrong, sum.share * 1e6);
    }
}

/* A candidate whose time is not known is in the table alone. */
static void place_marks(plane *all, const report_candidate *list, int count, int shape,
                        report_part part)
{
    for (int i = 0; i < count; i++) {
        mark *one = &all->marks[all->count];
        *one = (mark){.who = &list[i],
                      .sum = report_sum_of(&list[i], shape, part),
                      .measure = report_is_measure(&list[i])};
        if (one->sum.nanoseconds <= 0)
            continue;
        one->x = along(all->time, one->sum.nanoseconds, LEFT, RIGHT);
        one->y = one->sum.wrong > 0 ? along(all->wrong, one->sum.share * 1e6, BOTTOM, TOP) : NONE;
        all->count++;
    }
}

/* The names: each beside its point, or as near as there is room. */

static double name_width(const mark *one)
{
    return LETTER * (double)(strlen(one->who->name) + (one->measure ? strlen(MEASURE) : 0)) + 2;
}

static double overlap(box a, box b)
{
    double width = fmin(a.x1, b.x1) - fmax(a.x0, b.x0);
    double height = fmin(a.y1, b.y1) - fmax(a.y0, b.y0);
    return width > 0 && height > 0 ? width * height : 0;
}

static box around(const mark *one)
{
    return (box){one->x - 5, one->y - 5, one->x + 5, one->y + 5};
}

static bool is_free(const plane *all, int named, box name)
{
    if (name.x0 < LEFT + 1 || name.x1 > WIDTH - 1 || name.y0 < 1 || name.y1 > FLOOR - 1)
        return false;
    for (int i = 0; i < all->count; i++) {
        if (overlap(name, around(&all->marks[i])) > 0)
            return false;
        if (i < named && overlap(name, all->marks[i].name) > 0)
            return false;
    }
    return true;
}

static double distance_to(box name, const mark *one)
{
    double x = fmax(fmax(name.x0 - one->x, one->x - name.x1), 0);
    double y = fmax(fmax(name.y0 - one->y, one->y - name.y1), 0);
    return hypot(x, y);
}

/* Whose name it could be: how near the nearest of the other points is. */
static double nearest_other(const plane *all, int named, box name)
{
    double nearest = INFINITY;
    for (int i = 0; i < all->count; i++) {
        if (i != named)
            nearest = fmin(nearest, distance_to(name, &all->marks[i]));
    }
    return nearest;
}

/* A name belongs to the point that is nearest; one that is led to it stays off the others. */
static bool is_clear(const plane *all, int named, box name, bool led)
{
    double least = led ? ALONE : distance_to(name, &all->marks[named]);
    return nearest_other(all, named, name) > least;
}

/* A name whose middle is so far from the point, where its own box is left out of account. */
static box name_at(const mark *one, double degrees, double distance)
{
    double angle = degrees * 0.017453292519943295, half = name_width(one) / 2;
    double x = one->x + cos(angle) * (distance + half), y = one->y - sin(angle) * distance;
    return (box){x - half, y - LINE / 2.0, x + half, y + LINE / 2.0};
}

/* The nearest place that is free. */
static bool find_place(const plane *all, int named, bool led, box *name)
{
    static const int turns[] = {0,  180, 45,  -45,  135, -135, 90,  -90,
                                20, -20, 160, -160, 70,  -70,  110, -110};
    for (int distance = 7; distance < (led ? FAR : NEAR); distance += 3) {
        for (size_t i = 0; i < sizeof turns / sizeof *turns; i++) {
            *name = name_at(&all->marks[named], turns[i], distance + (turns[i] % 180 == 0 ? 0 : 4));
            if (is_free(all, named, *name) && is_clear(all, named, *name, led))
                return true;
        }
    }
    return false;
}

/* Without a place of its own a name is led to. */
static void name_mark(plane *all, int named)
{
    mark *one = &all->marks[named];
    if (find_place(all, named, false, &one->name))
        return;
    one->led = find_place(all, named, true, &one->name);
    if (!one->led)
        one->name = name_at(one, 0, 7);
}

/* The drawing. */

static void print_power(FILE *out, int power)
{
    static const char *const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    if (power < 4)
        fprintf(out, "%.0f", pow(10, power));
    else
        fprintf(out, "10%s", digits[power % 10]);
}

static void print_time_axis(FILE *out, const plane *all)
{
    for (int power = all->time.low; power <= all->time.high; power++) {
        double x = along(all->time, pow(10, power), LEFT, RIGHT);
        static const char *const units[] = {"ns", "µs", "ms", "s"};
        fprintf(out, "<path class=grid d='M%.1f %dV%d'/>", x, TOP, FLOOR);
        fprintf(out, "<text x=%.1f y=%d text-anchor=%s>%.0f %s</text>\n", x, FLOOR + 14,
                power == all->time.high ? "end" : "middle", pow(10, power % 3), units[power / 3]);
    }
    fprintf(out, "<text class=axis x=%d y=%d text-anchor=middle>processor time a ray</text>\n",
            (LEFT + RIGHT) / 2, FLOOR + 32);
}

static void print_wrong_axis(FILE *out, const plane *all)
{
    for (int power = all->wrong.low; power <= all->wrong.high; power++) {
        double y = along(all->wrong, pow(10, power), BOTTOM, TOP);
        fprintf(out, "<path class=grid d='M%d %.1fH%d'/>", LEFT, y, RIGHT);
        fprintf(out, "<text x=%d y=%.1f text-anchor=end>", LEFT - 5, y + 3.5);
        print_power(out, power);
        fputs("</text>\n", out);
    }
    fprintf(out,
            "<path class=none d='M%d %dH%d'/><text x=%d y=%.1f text-anchor=end>none</text>"
            "<text class=axis transform='translate(10 %d) rotate(-90)' text-anchor=middle>"
            "wrong per million</text>\n",
            LEFT, NONE, RIGHT, LEFT - 5, NONE + 3.5, (TOP + BOTTOM) / 2);
}

static void print_title(FILE *out, const mark *one)
{
    char time[REPORT_NUMBER], wrong[REPORT_NUMBER];
    report_time(one->sum.nanoseconds, time);
    report_per_million(&one->sum, wrong);
    fputs("<title>", out);
    report_text(out, one->who->name);
    fprintf(out, ": %s a ray; wrong decisions%s: %s</title>", time,
            one->sum.wrong > 0 ? " per million" : "", wrong);
}

static void print_mark(FILE *out, const mark *one)
{
    const char *kind = one->who->library ? "peer" : "tier";
    double x = fmin(fmax(one->x, one->name.x0), one->name.x1);
    double y = (one->name.y0 + one->name.y1) / 2;
    fprintf(out, "<g class=%s>", kind);
    print_title(out, one);
    if (one->led)
        fprintf(out, "<path class=lead d='M%.1f %.1fL%.1f %.1f'/>", one->x, one->y, x, y);
    if (one->who->library)
        fprintf(out, "<path class=dot d='M%.1f %.1fl4.5 4.5l-4.5 4.5l-4.5 -4.5z'/>", one->x,
                one->y - 4.5);
    else
        fprintf(out, "<circle class=dot cx=%.1f cy=%.1f r=4 />", one->x, one->y);
    fprintf(out, "<text class=name x=%.1f y=%.1f text-anchor=middle>",
            (one->name.x0 + one->name.x1) / 2, y + 3.6);
    report_text(out, one->who->name);
    fprintf(out, "%s</text></g>\n", one->measure ? MEASURE : "");
}

void report_print_plane(FILE *out, const report_candidate *list, int count, int shape,
                        report_part part)
{
    plane all = {.count = 0};
    measure_axes(&all, list, count, part);
    place_marks(&all, list, count, shape, part);
    for (int i = 0; i < all.count; i++)
        name_mark(&all, i);
    fprintf(out,
            "<svg class=plane viewBox='0 0 %d %d' role=img aria-label='Time a ray against wrong "
            "decisions: %s, %s'>\n",
            WIDTH, HEIGHT, sure_shape_name((sure_shape)shape),
            part == REPORT_TYPICAL ? "typical rays" : "the hard regimes");
    print_time_axis(out, &all);
    print_wrong_axis(out, &all);
    for (int i = 0; i < all.count; i++)
        print_mark(out, &all.marks[i]);
    fputs("</svg>\n", out);
}
