/* The page from top to bottom. */
#include "report_parts.h"

#include <inttypes.h>
#include <string.h>

static void print_head(FILE *out)
{
    fputs("<!doctype html>\n<html lang=en>\n<head>\n<meta charset=utf-8>\n"
          "<meta name=viewport content='width=device-width,initial-scale=1'>\n"
          "<title>surehit report: intersection routines against the exact answer</title>\n",
          out);
    report_print_style(out);
    fputs("</head>\n<body>\n", out);
}

static bool is_asked(const report_candidate *list, int count, int shape)
{
    for (int i = 0; i < count; i++) {
        if (report_answers(&list[i], shape))
            return true;
    }
    return false;
}

static bool has_part(const report_candidate *list, int count, int shape, report_part part)
{
    for (int i = 0; i < count; i++) {
        if (report_sum_of(&list[i], shape, part).regimes > 0)
            return true;
    }
    return false;
}

static uint64_t questions(const report_candidate *list, int count)
{
    uint64_t sum = 0;
    for (int i = 0; i < count * SURE_SHAPES * REGIMES; i++)
        sum += list[i / (SURE_SHAPES * REGIMES)].rows[i / REGIMES % SURE_SHAPES][i % REGIMES].cases;
    return sum;
}

static bool is_held(const report_candidate *list, int count, report_truth against)
{
    for (int i = 0; i < count; i++) {
        if (list[i].truth == against)
            return true;
    }
    return false;
}

static void print_introduction(FILE *out, const report_plan *plan, const report_candidate *list,
                               int count, const report_setting *setting)
{
    char all[REPORT_NUMBER], typical[REPORT_NUMBER], each[REPORT_NUMBER];
    report_count(questions(list, count), all);
    report_count(report_cases(plan, REGIME_TYPICAL), typical);
    report_count(plan->count, each);
    fprintf(
        out,
        "<header><h1>Where does this ray first meet this surface?</h1>\n"
        "<p>%d %s, asked %s questions whose right answer is known exactly: how often is "
        "each wrong, where, by how much, and what does it cost?</p>\n"
        "<p class=soft>%s <em>typical</em> rays a surface, as scenes have them, and %s of each "
        "of the hard kinds (<em>regimes</em>): grazing, far, huge, tiny, at rims, inside and so "
        "on. The same cases for everyone%s; a routine that computes in float is asked cases whose "
        "numbers are floats. surehit %s, seed %" PRIu64 ", <span class=whole>%s</span>.</p>\n",
        count, count == 1 ? "routine" : "routines", all, typical, each,
        is_held(list, count, REPORT_BY_REFERENCE) ? ", and more for certain and exact" : "",
        setting->version, plan->seed, setting->date);
    fputs("<nav><a href='#glance'>at a glance</a>", out);
    if (setting->scene_count > 0)
        fputs("<a href='#pictures'>pictures</a>", out);
    if (setting->trade->count > 0)
        fputs("<a href='#scenes'>scenes</a>", out);
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        const char *name = sure_shape_name((sure_shape)shape);
        if (is_asked(list, count, shape))
            fprintf(out, "<a href='#%s'>%s</a>", name, name);
    }
    fputs("<a href='#how'>how it was measured</a></nav></header>\n", out);
}

/* At a glance. */

static void print_name(FILE *out, const report_candidate *who)
{
    fputs("<tr><th scope=row>", out);
    report_text(out, who->name);
    fputs("</th>", out);
}

/* A routine's that does more than it is timed for is marked. */
static void print_time(FILE *out, const report_candidate *who, double nanoseconds)
{
    char text[REPORT_NUMBER];
    report_time(nanoseconds, text);
    fprintf(out, "<td>%s%s</td>", text, who->with_normals ? "ⁿ" : "");
}

static void print_glance_cell(FILE *out, const report_candidate *who, int shape, bool timed)
{
    report_sum sum = report_sum_of(who, shape, timed ? REPORT_TYPICAL : REPORT_HARD);
    char text[REPORT_NUMBER];
    if (sum.regimes == 0) {
        fputs("<td>–</td>", out);
    } else if (timed) {
        print_time(out, who, sum.nanoseconds);
    } else if (report_is_measure(who)) {
        fputs("<td class=h0>=</td>", out);
    } else {
        report_percent(sum.share, text);
        fprintf(out, "<td class=%s>%s</td>", report_heat(sum.share), text);
    }
}

static void print_glance(FILE *out, const report_candidate *list, int count)
{
    fputs(
        "<section id=glance><h2>At a glance</h2>\n<p>Left: wrong decisions (hit, miss or part) in "
        "the hard regimes, per cent; the mean over the regimes. Right: processor time for a "
        "typical ray’s hit, without the normal.</p>\n<div class=box tabindex=0><table>\n"
        "<thead><tr><th></th><th class=group colspan=5>wrong where it is hard, %</th>"
        "<th class=group colspan=5>time for a typical ray</th></tr>\n<tr><th>routine</th>",
        out);
    for (int i = 0; i < 2 * SURE_SHAPES; i++)
        fprintf(out, "<th scope=col>%s</th>", sure_shape_name((sure_shape)(i % SURE_SHAPES)));
    fputs("</tr></thead><tbody>\n", out);
    for (int i = 0; i < count; i++) {
        print_name(out, &list[i]);
        for (int cell = 0; cell < 2 * SURE_SHAPES; cell++)
            print_glance_cell(out, &list[i], cell % SURE_SHAPES, cell >= SURE_SHAPES);
        fputs("</tr>\n", out);
    }
    fputs("</tbody></table></div>\n<p class=soft>– : not answered, or not asked. Half of the "
          "cases of many regimes hit and half miss: 50 % is what guessing gives.",
          out);
    if (is_held(list, count, REPORT_BY_REFERENCE))
        fputs(" <b>certain</b> and <b>exact</b> are held against CGAL, which shares nothing with "
              "them; all others against exact.",
              out);
    if (is_held(list, count, REPORT_BY_LIKE))
        fputs(" * : held against <b>exact</b>, that is against itself (=) or its like: no "
              "independent evidence. surehit-reference, for which CGAL would be asked, was not "
              "found; docs/accuracy.md has what CGAL says of them.",
              out);
    for (int i = 0; i < count; i++) {
        if (!list[i].with_normals)
            continue;
        fputs(" ⁿ : the normal is in the time, for it is given with every hit.", out);
        break;
    }
    fputs("</p></section>\n", out);
}

/* A shape. */

static void print_planes(FILE *out, const report_candidate *list, int count, int shape)
{
    static const char *const titles[] = {"Typical rays: time and wrong decisions",
                                         "The hard regimes: time and wrong decisions"};
    static const char *const notes[] = {
        "● surehit’s tiers, ◇ other routines. Time: of hits alone, all asked the same cases in "
        "turns.",
        "Wrong: the mean over the regimes (for a routine in float: over those that floats can "
        "say). "
        "Time: the median regime’s; the slowest is in the table below."};
    fputs("<div class='columns two'>\n", out);
    for (int part = REPORT_TYPICAL; part <= REPORT_HARD; part++) {
        if (!has_part(list, count, shape, (report_part)part))
            continue;
        fprintf(out, "<div><h3>%s</h3>\n", titles[part]);
        report_print_plane(out, list, count, shape, (report_part)part);
        fprintf(out, "<p class=soft>%s</p></div>\n", notes[part]);
    }
    fputs("</div>\n", out);
}

static void print_t(FILE *out, const report_row *row)
{
    char text[REPORT_NUMBER];
    const double sizes[] = {row->t_median, row->t_q99, row->t_most};
    if (row->t_count == 0) {
        fputs("<td>–</td><td>–</td><td>–</td><td>–</td>", out);
        return;
    }
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        report_ulps(sizes[i], text);
        fprintf(out, "<td>%s</td>", text);
    }
    report_percent((double)row->t_right / (double)row->t_count, text);
    fprintf(out, "<td>%s</td>", text);
}

static void print_sum(FILE *out, const report_candidate *who, const report_sum *sum, bool slowest)
{
    char text[REPORT_NUMBER];
    if (sum->regimes == 0) {
        fprintf(out, "<td>–</td><td>–</td>%s", slowest ? "<td>–</td>" : "");
        return;
    }
    report_per_million(sum, text);
    fprintf(out, "<td>%s</td>", report_is_measure(who) ? "=" : text);
    print_time(out, who, sum->nanoseconds);
    if (slowest)
        print_time(out, who, sum->slowest);
}

static void print_figures_of(FILE *out, const report_candidate *who, int shape)
{
    char text[REPORT_NUMBER];
    report_sum typical = report_sum_of(who, shape, REPORT_TYPICAL);
    report_sum hard = report_sum_of(who, shape, REPORT_HARD);
    print_name(out, who);
    print_sum(out, who, &typical, false);
    print_t(out, &who->rows[shape][REGIME_TYPICAL]);
    print_sum(out, who, &hard, true);
    report_count(typical.breaches + hard.breaches, text);
    fprintf(out, "<td>%s</td></tr>\n", text);
}

static void print_figures(FILE *out, const report_candidate *list, int count, int shape)
{
    fputs("<h3>In figures</h3>\n<div class=box tabindex=0><table><thead><tr><th></th>"
          "<th class=group colspan=2>typical rays</th>"
          "<th class=group colspan=4>error of t in typical rays, ulps</th>"
          "<th class=group colspan=3>hard regimes</th><th class=group>all</th></tr>\n"
          "<tr><th>routine</th><th>wrong per million</th><th>time</th><th>median</th>"
          "<th>99 %</th><th>largest</th><th>rightly rounded, %</th><th>wrong per million</th>"
          "<th>time, median</th><th>slowest</th><th>breaches</th></tr></thead><tbody>\n",
          out);
    for (int i = 0; i < count; i++) {
        if (report_answers(&list[i], shape))
            print_figures_of(out, &list[i], shape);
    }
    fputs(
        "</tbody></table></div>\n<p class=soft>Errors of t in ulps: how many doubles (floats, for "
        "a routine in float) lie between the answer and the rightly rounded one. Breaches of the "
        "contract: a NaN, t outside its interval, invalid input accepted, outputs touched on a "
        "miss, a changing answer, a leak, a crash, no answer.</p>\n",
        out);
}

static void print_shape(FILE *out, const report_plan *plan, const report_candidate *list, int count,
                        int shape)
{
    const char *name = sure_shape_name((sure_shape)shape);
    fprintf(out, "<section class=shape id=%s><h2>%c%s</h2>\n", name, name[0] - 'a' + 'A', name + 1);
    print_planes(out, list, count, shape);
    fputs("<div class='columns wide'><div><h3>Wrong decisions by regime, %</h3>\n", out);
    report_print_heat(out, plan, list, count, shape);
    fputs("<p class=soft>† : and breaches of the contract, or cases given up after too many "
          "crashes.</p></div>\n<div><h3>How far off t is, where the hit is right</h3>\n",
          out);
    report_print_histograms(out, list, count, shape);
    fputs("<p class=soft>Shares of the hits by size of the error: <b class=typical>typical rays "
          "upwards</b>, <b class=hard>hard regimes downwards</b>. Heights grow with the root of "
          "the share: 1 % is a tenth of the full height.</p></div></div>\n",
          out);
    print_figures(out, list, count, shape);
    fputs("</section>\n", out);
}

/* The end. */

static void print_words_for_judge(FILE *out, const report_candidate *who)
{
    const char *path = who->library, *slash = path ? strrchr(path, '/') : NULL;
    fprintf(out, "<code>%s ", path ? "--candidate" : "--tier");
    report_text(out, slash ? slash + 1 : path ? path : sure_tier_name(who->tier));
    fprintf(out, "%s</code>", who->truth == REPORT_BY_REFERENCE ? " --truth reference" : "");
}

static const char *truth_name(const report_candidate *who)
{
    switch (who->truth) {
    case REPORT_BY_EXACT: return "exact";
    case REPORT_BY_REFERENCE: return "CGAL";
    case REPORT_BY_LIKE: break;
    }
    return report_is_measure(who) ? "itself: no independent evidence"
                                  : "exact: no independent evidence";
}

static void print_candidate(FILE *out, const report_candidate *who)
{
    char cases[REPORT_NUMBER];
    print_name(out, who);
    fputs("<td class=left>", out);
    report_text(out, who->about);
    if (who->trouble[0] != '\0') {
        fputs("</td><td>–</td><td>–</td><td>–</td><td class=left>not asked: ", out);
        report_text(out, who->trouble);
    } else {
        report_count(questions(who, 1), cases);
        fprintf(out, "</td><td class=left>%s</td><td class=left>%s</td><td>%s</td><td class=left>",
                who->in_float ? "float" : "double", truth_name(who), cases);
        print_words_for_judge(out, who);
    }
    fputs("</td></tr>\n", out);
}

static void print_candidates(FILE *out, const report_candidate *list, int count)
{
    fputs("<h3>Who was asked, and held against what</h3>\n<div class=box tabindex=0><table><thead>"
          "<tr><th>routine</th><th class=left>what it is</th><th class=left>computes in</th>"
          "<th class=left>held against</th><th>in cases</th>"
          "<th class=left>surehit judge …</th></tr></thead><tbody>\n",
          out);
    for (int i = 0; i < count; i++)
        print_candidate(out, &list[i]);
    fputs("</tbody></table></div>\n", out);
}

/* One line each; docs/regimes.md has more. */
static const char *const regime_glosses[REGIMES] = {
    [REGIME_TYPICAL] = "nothing special: sizes and distances over six powers of ten",
    [REGIME_GRAZING] = "rays that pass within 10⁻² to 10⁻¹⁶ of touching",
    [REGIME_TANGENT] = "rays that touch exactly",
    [REGIME_NEIGHBOUR] = "exact touches with one number moved by its last bits",
    [REGIME_FAR] = "objects 10³ to 10¹⁵ times their size away",
    [REGIME_HUGE] = "coordinates up to 10³⁰⁰: products overflow",
    [REGIME_TINY] = "numbers so small that products underflow",
    [REGIME_INSIDE] = "rays that start inside the solid",
    [REGIME_ON_SURFACE] = "rays that start on the surface, as shadow rays do",
    [REGIME_RIM] = "through an edge or just beside it",
    [REGIME_APEX] = "through a cone’s tip or just beside it",
    [REGIME_AXIS_PARALLEL] = "along the axis, exactly and nearly",
    [REGIME_WALL_PARALLEL] = "along a cone’s wall, exactly and nearly",
    [REGIME_EDGE_ON] = "in the plane of a disc or cap, exactly and nearly",
    [REGIME_NEEDLE] = "a million million times as high as wide",
    [REGIME_COIN] = "a million million times as wide as high",
    [REGIME_DEGENERATE] = "radius 0, zeros of either sign, and invalid input",
    [REGIME_INTERVAL] = "t_min or t_max at the hit or one bit beside it",
    [REGIME_MIDPOINT] = "t halfway between two doubles; ranges that end beside it",
    [REGIME_NONUNIT] = "directions, normals and axes of length 10⁻¹⁵⁰ to 10¹⁵⁰",
    [REGIME_INTEGERS] = "a small world of whole numbers, everything degenerate at once",
    [REGIME_BITS] = "all exponents and bit patterns, infinities and NaN among them",
    [REGIME_OFF_SURFACE] = "rays that start one bit off the surface, as shadow rays do",
    [REGIME_NEARLY_PARALLEL] = "a step through a face for up to 2³⁰ along it",
    [REGIME_FAR_TANGENT] = "exact touches from up to 2⁴⁵ away, and one bit beside",
    [REGIME_SCALED_NEIGHBOUR] = "exact touches and their neighbours, at 10³⁰⁰ and 10⁻²⁸⁸",
};

static void print_regimes(FILE *out)
{
    fputs("<details><summary>What the regimes are</summary><dl>\n", out);
    for (int which = 0; which < REGIMES; which++)
        fprintf(out, "<dt>%s</dt><dd>%s</dd>\n", regime_name((regime)which), regime_glosses[which]);
    fputs("</dl></details>\n", out);
}

static void print_how(FILE *out, const report_plan *plan, const report_candidate *list, int count,
                      const report_setting *setting)
{
    char typical[REPORT_NUMBER], each[REPORT_NUMBER], dear[REPORT_NUMBER];
    report_count(report_cases(plan, REGIME_TYPICAL), typical);
    report_count(plan->count, each);
    report_count(report_cases(plan, REGIME_BITS), dear);
    fprintf(out,
            "<section id=how><h2>How it was measured</h2>\n"
            "<p><b>Cases</b>: %s of each shape and regime; %s in <code>typical</code>; %s in "
            "<code>bits</code> and <code>degenerate</code>, whose exact answer may take "
            "milliseconds.",
            each, typical, dear);
    if (is_held(list, count, REPORT_BY_REFERENCE))
        fprintf(out, " %d times as many for certain and exact, the others’ among them.",
                REPORT_REFERENCE_CASES);
    fputs(" All are made from the seed, the same on every machine; docs/regimes.md says how.</p>\n",
          out);
    print_regimes(out);
    fputs(
        "<p><b>Right answers</b>: the exact tier’s, and for certain and exact themselves CGAL’s, "
        "which the table below says of each routine; inputs are exact numbers, solids are closed, "
        "a touch is a hit (docs/contract.md). Wrong is a false hit, a false miss, a wrong part, "
        "a valid case refused, or no answer, in the share of the valid cases. “None in N” "
        "leaves room: with 95 % confidence the true share is below 3.84 / (N + 3.84).</p>\n"
        "<p><b>Time</b>: processor time of one thread for hits alone, without normals. Tiers and "
        "other routines are called alike, one ray at a time, each in a process of its own, and "
        "take turns at the same cases: five rounds, in an order that changes, of which the median "
        "counts; of each the faster of two passes. Nothing else is judged meanwhile.</p>\n",
        out);
    print_candidates(out, list, count);
    fputs("<h3>Again</h3>\n<p>This page, and any one cell of it:</p>\n<pre>", out);
    report_text(out, setting->command);
    fprintf(out,
            "\nsurehit judge --tier textbook --shape cone --regime rim --count %" PRIu64
            " --seed %" PRIu64 "</pre>\n<p class=soft>",
            plan->count, plan->seed);
    report_text(out, setting->cpu);
    fputs("; ", out);
    report_text(out, setting->compiler);
    fputs(" ", out);
    report_text(out, setting->flags);
    fprintf(out, "; %.0f s of judging. surehit %s, %s.</p></section>\n", setting->seconds,
            setting->version, setting->date);
}

void report_print(FILE *out, const report_plan *plan, const report_candidate *list, int count,
                  const report_setting *setting)
{
    print_head(out);
    print_introduction(out, plan, list, count, setting);
    fputs("<main>\n", out);
    print_glance(out, list, count);
    if (setting->scene_count > 0)
        fputs("<section id=pictures><h2>The same scene, by each tier</h2>\n", out);
    for (int i = 0; i < setting->scene_count; i++)
        report_print_scene(out, &setting->scenes[i]);
    fputs(setting->scene_count > 0 ? "</section>\n" : "", out);
    if (setting->trade->count > 0)
        report_print_trade(out, setting->trade);
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        if (is_asked(list, count, shape))
            print_shape(out, plan, list, count, shape);
    }
    print_how(out, plan, list, count, setting);
    fputs("</main>\n</body>\n</html>\n", out);
}
