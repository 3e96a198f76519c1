/* SPDX-License-Identifier: MIT */
/* What the first stages compute, as it is computed, for the scripts of docs/proofs to be held
 * against (test_proofs.py expressions): a line "script: name = expression" each. */
#include "tape.hpp"

#include <map>
#include <stdio.h>
#include <string>

enum level { TERMS, FACTORS, ATOM };
struct expression {
    std::string text;
    level binds;
};

static std::map<int, std::string> names;

static std::string atom(const expression &x)
{
    return x.binds == ATOM ? x.text : "(" + x.text + ")";
}

static std::string factor(const expression &x)
{
    return x.binds == TERMS ? "(" + x.text + ")" : x.text;
}

/* The components of y for those of x, and so on. */
static std::string turned(std::string text)
{
    for (size_t i = 1; i < text.size(); i++)
        if (text[i - 1] == '.' && text[i] >= 'x' && text[i] <= 'z')
            text[i] = text[i] == 'z' ? 'x' : static_cast<char>(text[i] + 1);
    return text;
}

/* "v.x" without its component; "" for anything else. */
static std::string vector_of(const std::string &text, char component)
{
    size_t end = text.size();
    bool is = end > 2 && text[end - 1] == component && text[end - 2] == '.' &&
              text.find(' ') == (text[0] == '(' ? text.find(' ') : std::string::npos);
    return is ? text.substr(0, end - 2) : "";
}

/* "v * w" as its two factors, if that is what it is. */
static bool factors_of(const std::string &text, std::string pair[2])
{
    int depth = 0;
    for (size_t i = 0; i < text.size(); i++) {
        depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
        if (depth == 0 && text.compare(i, 3, " * ") == 0) {
            pair[0] = text.substr(0, i);
            pair[1] = text.substr(i + 3);
            return pair[1].find(" * ") == std::string::npos || pair[1][0] == '(';
        }
    }
    return false;
}

/* v.x w.x + v.y w.y + v.z w.z is v.w, and of other three terms that are alike it is their sum. */
static bool sum_of_components(const std::string terms[3], expression *sum)
{
    std::string pair[2];
    if (turned(terms[0]) != terms[1] || turned(terms[1]) != terms[2] || terms[0] == terms[1])
        return false;
    sum->binds = ATOM;
    sum->text = "sum(" + terms[0] + ")";
    if (factors_of(terms[0], pair)) {
        std::string v = vector_of(pair[0], 'x'), w = vector_of(pair[1], 'x');
        if (!v.empty() && !w.empty())
            sum->text = v + "." + w;
    }
    return true;
}

/* v.y w.z - v.z w.y is (v x w).x */
static bool component_of_cross(const std::string &plus, const std::string &minus, expression *found)
{
    std::string p[2], q[2];
    if (!factors_of(plus, p) || !factors_of(minus, q))
        return false;
    for (char c = 'x'; c <= 'z'; c++) {
        char next = c == 'z' ? 'x' : static_cast<char>(c + 1);
        char last = c == 'x' ? 'z' : static_cast<char>(c - 1);
        std::string v = vector_of(p[0], next), w = vector_of(p[1], last);
        if (!v.empty() && !w.empty() && v == vector_of(q[0], last) && w == vector_of(q[1], next)) {
            *found = {"(" + v + " x " + w + ")." + c, ATOM};
            return true;
        }
    }
    return false;
}

#define NAMED(constant)                                                                            \
    {constant, #constant},                                                                         \
    {                                                                                              \
        (constant) * (constant), #constant "^2"                                                    \
    }
static const std::map<double, const char *> CONSTANTS = {NAMED(AXIAL_FLOOR),
                                                         NAMED(HEIGHT_FLOOR),
                                                         NAMED(SURE_HEIGHT_BOUND),
                                                         NAMED(AXIAL_TILT),
                                                         NAMED(SURE_CROSSING_T_BOUND),
                                                         NAMED(SURE_DISC_FOOT_BOUND),
                                                         NAMED(SURE_CYLINDER_DISCRIMINANT_BOUND),
                                                         NAMED(SURE_CONE_DISCRIMINANT_BOUND)};

static expression constant(double x)
{
    char text[40];
    if (CONSTANTS.count(x))
        return {CONSTANTS.at(x), ATOM};
    snprintf(text, sizeof text, x == floor(x) && fabs(x) < 100 ? "%.0f" : "%a", x);
    return {text, ATOM};
}

static expression spelt(int at, double value);

static expression spelt_sum(const step &s, const expression &x, const expression &y)
{
    expression found;
    const step &left = tape[static_cast<size_t>(s.x)];
    if (s.what == SUM && left.what == SUM && s.x != 0) {
        const std::string terms[] = {spelt(left.x, left.of_x).text, spelt(left.y, left.of_y).text,
                                     y.text};
        if (sum_of_components(terms, &found))
            return found;
    }
    if (s.what == DIFFERENCE && component_of_cross(x.text, y.text, &found))
        return found;
    for (char c = 'x'; s.what == DIFFERENCE && c <= 'z'; c++) {
        std::string from = vector_of(x.text, c), to = vector_of(y.text, c);
        if (to == "p" && (from == "o" || from == "q"))
            return {std::string(from == "o" ? "m." : "A.") + c, ATOM};
    }
    return {x.text + (s.what == SUM ? " + " : " - ") + factor(y), TERMS};
}

/* Of a step, or of a constant. */
static expression spelt(int at, double value)
{
    if (at == 0)
        return constant(value);
    if (names.count(at))
        return {names[at], ATOM};
    const step s = tape[static_cast<size_t>(at)];
    expression x = spelt(s.x, s.of_x), y = {"", ATOM};
    if (s.what >= SIGNED)
        y = spelt(s.y, s.of_y);
    switch (s.what) {
    case NEGATION: return {"-" + atom(x), FACTORS};
    case MAGNITUDE: return {"|" + x.text + "|", ATOM};
    case ROOT: return {"sqrt(" + x.text + ")", ATOM};
    case SIGNED: return {"copysign(" + x.text + ", " + y.text + ")", ATOM};
    case PRODUCT: return {factor(x) + " * " + atom(y), FACTORS};
    case QUOTIENT: return {factor(x) + " / " + atom(y), FACTORS};
    default: return spelt_sum(s, x, y);
    }
}

static std::string spelt(scalar x)
{
    return spelt(x.step, x.value).text;
}

static void line(const std::string &script, const char *name, scalar x)
{
    printf("%s: %s = %s\n", script.c_str(), name, spelt(x).c_str());
}

static void decision(const char *script, size_t which)
{
    const comparison &asked = comparisons[which];
    printf("%s: %s > %s\n", script, spelt(asked.greater).c_str(), spelt(asked.less).c_str());
}

/* The query, its numbers named: o and d, p for where m = o - p is seen from, q for A = q - p. */
static query named(sure_shape shape, const double x[])
{
    const sure_shape_field *after = &sure_shape_info_of(shape)->fields[1];
    const int radius = after->kind == SURE_KIND_RADIUS ? OBJECT + after->at : -1;
    const char *first = shape_tapers(shape) ? "q" : "p";
    const char *second = shape_tapers(shape) ? "p" : after->kind == SURE_KIND_NORMAL ? "N" : "q";
    const char *vectors[] = {"o", "d", first, second};
    query q = recorded(shape, x);
    names.clear();
    for (int i = 0; i < T_MIN; i++)
        names[i + 1] =
            i == T_MIN - 1 || i == radius ? "r" : std::string(vectors[i / 3]) + "." + "xyz"[i % 3];
    names[T_MIN + 1] = "t_min";
    return q;
}

static const double LINE[] = {0.3, -4.7, 0.4, 0.1, 1.3, -0.05};
#define ALONG_LINE LINE[0], LINE[1], LINE[2], LINE[3], LINE[4], LINE[5]

static void planar()
{
    const double x[INPUTS] = {ALONG_LINE, 0.2, 0.1, -0.3, 0.1, 0.9, -0.2, 1.1};
    query q = named(SURE_SHAPE_DISC, x);
    const sure_plane &plane = q.object.as.plane;
    flat_terms of = flat_terms_of(&q.ray, &plane.point, &plane.normal);
    line("crossing", "e", of.e);
    line("crossing", "h", of.h);
    line("crossing", "late", flat_late(&of, q.ray.t_min));
    filter_interval found;
    plane_filter(&q.ray, &plane, &found);
    line("crossing", "t", found.enter.t);
    line("crossing", "error", found.enter.error);
    q = named(SURE_SHAPE_DISC, x);
    disc_filter(&q.ray, &q.object.as.disc, &found);
    decision("disc_radius", 0);
    decision("disc_radius", 1);
}

static void sphere()
{
    const double x[INPUTS] = {ALONG_LINE, 0.2, 0.1, -0.3, 1.1};
    query q = named(SURE_SHAPE_SPHERE, x);
    const sure_sphere &object = q.object.as.sphere;
    sphere_terms of = sphere_terms_of(&q.ray, &object);
    line("sphere_discriminant", "D", of.discriminant);
    line("sphere_close", "D", sphere_close_terms_of(&of, object.radius).discriminant);
    filter_interval found;
    sphere_filter(&q.ray, &object, &found);
    line("sphere_t", "t", found.enter.t);
    line("sphere_t", "t", found.leave.t);
}

static void discriminant(const char *script, scalar d, scalar certain)
{
    line(script, "D", d);
    line(script, "certain", certain);
}

static void of_cylinder(const query &q)
{
    axial_terms of = cylinder_terms_of(&q.ray, &q.object.as.cylinder);
    discriminant("cylinder_discriminant", of.inner - of.outer, of.certain);
}

static void of_cone(const query &q)
{
    axial_terms of = cone_terms_of(&q.ray, &q.object.as.cone);
    discriminant("cone_discriminant", of.inner - of.outer, of.certain);
}

static void capped(sure_shape shape, void (*terms)(const query &), const char *leading,
                   const char *wall, const double x[])
{
    query q = named(shape, x);
    filter_interval found;
    terms(q);
    filtered(q, &found);
    line(leading, "a", inverted[0]);
    line("axial_plane", "e", inverted[1]);
    names[inverted[0].step] = "a";
    names[inverted[1].step] = "e";
    for (const filter_end &end : {found.enter, found.leave})
        line(end.end.part == SURE_PART_WALL ? wall : "axial_plane", "t", end.t);
}

static void heights(const double x[])
{
    query q = named(SURE_SHAPE_CYLINDER, x);
    const sure_cylinder &s = q.object.as.cylinder;
    const sure_vec3 &p = q.ray.origin;
    const height_query below = {s.base, s.top, p, s.base, 0, false};
    const height_query beyond = {s.base, s.top, p, s.top, 0, false};
    const height_query within = {s.base, s.top, p, s.base, s.radius, true};
    line("height", "along", height_f64(NULL, &below));
    line("height", "along", height_f64(NULL, &beyond));
    line("height", "slant", height_f64(NULL, &within));
    scalar value;
    comparisons.clear();
    height_filter(&within, &value);
    line("height", "error", comparisons.back().less);
}

int main()
{
    const double across[INPUTS] = {ALONG_LINE, -0.8, 0.1, -0.3, 1.9, 0.2, -0.1, 1.1};
    const double along[INPUTS] = {ALONG_LINE, 0.2, 0.1, -0.3, 0.1, -1.9, 0.2, 1.1};
    planar();
    sphere();
    heights(across);
    for (const double *x : {across, along})
        capped(SURE_SHAPE_CYLINDER, of_cylinder, "cylinder_wall", "cylinder_wall", x);
    for (const double *x : {across, along})
        capped(SURE_SHAPE_CONE, of_cone, "cone_leading", "cone_wall", x);
    return 0;
}
