#include "face_by_face.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include <gmp.h>

__extension__ typedef __int128 wide;

static long dot(const int v[3], const int w[3])
{
    return (long)v[0] * w[0] + (long)v[1] * w[1] + (long)v[2] * w[2];
}

static int sign_of(wide x)
{
    return (x > 0) - (x < 0);
}

/* p + q sqrt(root) */
static int surd_sign(wide p, wide q, long root)
{
    int sign_p = sign_of(p), sign_q = root == 0 ? 0 : sign_of(q);
    if (sign_p == 0 || sign_q == 0 || sign_p == sign_q)
        return sign_p != 0 ? sign_p : sign_q;
    return sign_p * sign_of(p * p - q * q * root);
}

int surd_order(surd x, surd y, long root)
{
    return surd_sign((wide)x.u * y.w - (wide)y.u * x.w, (wide)x.v * y.w - (wide)y.v * x.w, root);
}

static surd quotient(long u, long v, long w)
{
    return w > 0 ? (surd){u, v, w} : (surd){-u, -v, -w};
}

static void add_piece(faces *f, surd low, surd high, sure_part part)
{
    f->piece[f->count++] = (piece){low, high, part};
}

/* A disc about `centre` in the plane at right angles to the axis. `scale` brings its
 * discriminant in its own plane to that of the wall. */
static void add_disc(faces *f, const lattice_case *c, const int centre[3], long scale,
                     sure_part part)
{
    int w[3], at[3];
    for (int i = 0; i < 3; i++)
        w[i] = c->origin[i] - centre[i];
    long along = dot(c->axis, c->direction), above = dot(c->axis, w);
    if (along != 0) {
        for (int i = 0; i < 3; i++)
            at[i] = (int)(along * w[i] - above * c->direction[i]);
        surd t = quotient(-above, 0, along);
        if (dot(at, at) <= (long)c->radius * c->radius * along * along)
            add_piece(f, t, t, part);
    } else if (above == 0) {
        long a = scale * dot(c->direction, c->direction);
        long b = scale * dot(w, c->direction);
        long discriminant = b * b - a * scale * (dot(w, w) - (long)c->radius * c->radius);
        if (discriminant >= 0) {
            f->root = discriminant;
            add_piece(f, (surd){-b, -1, a}, (surd){-b, 1, a}, part);
        }
    }
}

/* Is low <= h0 + h1 t <= high? */
static bool between(surd t, long root, long h0, long h1, long low, long high)
{
    return surd_sign((wide)(h0 - low) * t.w + (wide)h1 * t.u, (wide)h1 * t.v, root) >= 0 &&
           surd_sign((wide)(h0 - high) * t.w + (wide)h1 * t.u, (wide)h1 * t.v, root) <= 0;
}

/* a t^2 + 2 b t + c = 0 where the height h0 + h1 t is in 0..top. */
static void add_wall(faces *f, long a, long b, long c, const long h[2], long top, sure_part part)
{
    if (a == 0 && b == 0) {
        if (c == 0) {
            surd at_base = quotient(-h[0], 0, h[1]), at_top = quotient(top - h[0], 0, h[1]);
            add_piece(f, h[1] > 0 ? at_base : at_top, h[1] > 0 ? at_top : at_base, part);
        }
    } else if (a == 0) {
        surd t = quotient(-c, 0, 2 * b);
        if (between(t, 0, h[0], h[1], 0, top))
            add_piece(f, t, t, part);
    } else if (b * b - a * c >= 0) {
        f->root = b * b - a * c;
        for (int sign = -1; sign <= 1; sign += 2) {
            surd t = quotient(-b, sign, a);
            if (between(t, f->root, h[0], h[1], 0, top))
                add_piece(f, t, t, part);
        }
    }
}

static void cylinder_faces(faces *f, const lattice_case *c, const int w[3])
{
    const int *d = c->direction, *axis = c->axis;
    long n = dot(axis, axis), square = (long)c->radius * c->radius;
    long h[2] = {dot(axis, w), dot(axis, d)};
    int top[3];
    for (int i = 0; i < 3; i++)
        top[i] = c->anchor[i] + axis[i];
    add_disc(f, c, c->anchor, n, SURE_PART_BASE);
    add_disc(f, c, top, n, SURE_PART_TOP);
    add_wall(f, n * dot(d, d) - h[1] * h[1], n * dot(w, d) - h[0] * h[1],
             n * dot(w, w) - h[0] * h[0] - square * n, h, n, SURE_PART_WALL);
}

/* From the apex, with X = P - apex: A^4 X^2 = (A^2 + r^2) (X.A)^2, the notes' cosine form. */
static void cone_faces(faces *f, const lattice_case *c, const int w[3])
{
    const int *d = c->direction, *axis = c->axis;
    long n = dot(axis, axis), m = n + (long)c->radius * c->radius;
    long h[2] = {dot(axis, w), dot(axis, d)};
    int x[3];
    for (int i = 0; i < 3; i++)
        x[i] = w[i] - axis[i];
    long along = dot(x, axis);
    add_disc(f, c, c->anchor, n * n, SURE_PART_BASE);
    add_wall(f, n * n * dot(d, d) - m * h[1] * h[1], n * n * dot(x, d) - m * along * h[1],
             n * n * dot(x, x) - m * along * along, h, n, SURE_PART_WALL);
}

static void plane_faces(faces *f, const lattice_case *c, const int w[3])
{
    long along = dot(c->axis, c->direction), above = dot(c->axis, w);
    f->endless = along == 0 && above == 0;
    if (along != 0) {
        surd t = quotient(-above, 0, along);
        add_piece(f, t, t, SURE_PART_SURFACE);
    }
}

faces faces_on_line(const lattice_case *c)
{
    faces f = {.count = 0};
    int w[3];
    for (int i = 0; i < 3; i++)
        w[i] = c->origin[i] - c->anchor[i];
    long no_height[2] = {0, 0};
    switch (c->shape) {
    case SURE_SHAPE_PLANE:
        plane_faces(&f, c, w);
        break;
    case SURE_SHAPE_DISC:
        add_disc(&f, c, c->anchor, 1, SURE_PART_SURFACE);
        break;
    case SURE_SHAPE_SPHERE:
        add_wall(&f, dot(c->direction, c->direction), dot(w, c->direction),
                 dot(w, w) - (long)c->radius * c->radius, no_height, 0, SURE_PART_SURFACE);
        break;
    case SURE_SHAPE_CYLINDER:
        cylinder_faces(&f, c, w);
        break;
    case SURE_SHAPE_CONE:
        cone_faces(&f, c, w);
        break;
    }
    return f;
}

/* g0 + g1 t + g2 t^2, rational. */
typedef struct {
    mpq_t g[3];
} rational_quadratic;

static void quadratic_init(rational_quadratic *p, long g0, long g1)
{
    mpq_inits(p->g[0], p->g[1], p->g[2], (mpq_ptr)NULL);
    mpq_set_si(p->g[0], g0, 1);
    mpq_set_si(p->g[1], g1, 1);
}

static void quadratic_clear(rational_quadratic *p)
{
    mpq_clears(p->g[0], p->g[1], p->g[2], (mpq_ptr)NULL);
}

/* x += factor * y, factor an integer */
static void add_multiple(mpq_t x, const mpq_t y, long factor)
{
    mpq_t product;
    mpq_init(product);
    mpq_set_si(product, factor, 1);
    mpq_mul(product, product, y);
    mpq_add(x, x, product);
    mpq_clear(product);
}

static int rational_surd_sign(mpq_t p, mpq_t q, long root)
{
    int sign_p = mpq_sgn(p), sign_q = root == 0 ? 0 : mpq_sgn(q);
    if (sign_p == 0 || sign_q == 0 || sign_p == sign_q)
        return sign_p != 0 ? sign_p : sign_q;
    mpq_t difference;
    mpq_init(difference);
    mpq_mul(p, p, p);
    mpq_mul(q, q, q);
    mpq_set(difference, p);
    add_multiple(difference, q, -root);
    int sign = sign_p * mpq_sgn(difference);
    mpq_clear(difference);
    return sign;
}

/* w^2 p(t) = (g0 w^2 + g1 u w + g2 (u^2 + v^2 root)) + (g1 v w + 2 g2 u v) sqrt(root) */
static int sign_at(const rational_quadratic *p, surd t, long root)
{
    mpq_t rational, irrational;
    mpq_inits(rational, irrational, (mpq_ptr)NULL);
    add_multiple(rational, p->g[0], t.w * t.w);
    add_multiple(rational, p->g[1], t.u * t.w);
    add_multiple(rational, p->g[2], t.u * t.u + t.v * t.v * root);
    add_multiple(irrational, p->g[1], t.v * t.w);
    add_multiple(irrational, p->g[2], 2 * t.u * t.v);
    int sign = rational_surd_sign(rational, irrational, root);
    mpq_clears(rational, irrational, (mpq_ptr)NULL);
    return sign;
}

/* A number is told by the sign of number - y. */
typedef int sign_of_excess(const void *number, const mpq_t y);

static bool is_nearest(sign_of_excess *excess, const void *number, double y)
{
    uint64_t bits;
    memcpy(&bits, &y, sizeof bits);
    if (y == 0 && bits != 0)
        return false;
    bool even = bits % 2 == 0, nearest = true;
    mpq_t middle, neighbour;
    mpq_inits(middle, neighbour, (mpq_ptr)NULL);
    for (int side = -1; side <= 1; side += 2) {
        mpq_set_d(middle, y);
        mpq_set_d(neighbour, nextafter(y, side < 0 ? -INFINITY : INFINITY));
        mpq_add(middle, middle, neighbour);
        mpq_div_2exp(middle, middle, 1);
        int beyond = side * excess(number, middle);
        nearest = nearest && (beyond < 0 || (beyond == 0 && even));
    }
    mpq_clears(middle, neighbour, (mpq_ptr)NULL);
    return nearest;
}

typedef struct {
    surd value;
    long root;
} rooted;

static int surd_excess(const void *number, const mpq_t y)
{
    const rooted *x = number;
    rational_quadratic p;
    quadratic_init(&p, 0, 1);
    mpq_neg(p.g[0], y);
    int sign = sign_at(&p, x->value, x->root);
    quadratic_clear(&p);
    return sign;
}

bool surd_nearest(surd x, long root, double y)
{
    rooted number = {x, root};
    return is_nearest(surd_excess, &number, y);
}

/* (g0 + g1 t) / ((s0 + s1 t) sqrt(n)) with the divisor positive: by squaring. */
typedef struct {
    rooted t;
    long g0, g1, s0, s1, n;
} normal_component;

static int normal_excess(const void *number, const mpq_t y)
{
    const normal_component *c = number;
    rational_quadratic p;
    mpq_t square;
    quadratic_init(&p, c->g0, c->g1);
    int sign = sign_at(&p, c->t.value, c->t.root), sign_y = mpq_sgn(y);
    quadratic_clear(&p);
    if (sign != sign_y || sign == 0)
        return (sign > sign_y) - (sign < sign_y);

    quadratic_init(&p, c->g0 * c->g0, 2 * c->g0 * c->g1);
    mpq_set_si(p.g[2], c->g1 * c->g1, 1);
    mpq_init(square);
    mpq_mul(square, y, y);
    add_multiple(p.g[0], square, -c->n * c->s0 * c->s0);
    add_multiple(p.g[1], square, -c->n * 2 * c->s0 * c->s1);
    add_multiple(p.g[2], square, -c->n * c->s1 * c->s1);
    sign *= sign_at(&p, c->t.value, c->t.root);
    mpq_clear(square);
    quadratic_clear(&p);
    return sign;
}

/* v / |v| */
static void constant_normal(normal_component *out, const int v[3], int sign, int i)
{
    out->g0 = sign * v[i];
    out->s0 = 1;
    out->n = dot(v, v);
}

static bool at_apex(const lattice_case *c, const int w[3], surd x, long root)
{
    long n = dot(c->axis, c->axis);
    return between(x, root, dot(c->axis, w), dot(c->axis, c->direction), n, n);
}

/* Sphere (P - C) / r; cylinder Q / (A^2 r), Q = A^2 W - (A.W) A; cone
 * (A^2 Q + r^2 j A) / (r j |A| sqrt(A^2 + r^2)), j = A^2 - A.W. */
static void round_normal(normal_component *out, const lattice_case *c, const int w[3], int i)
{
    const int *axis = c->axis, *d = c->direction;
    long n = dot(axis, axis), r = c->radius;
    long q0 = n * w[i] - dot(axis, w) * axis[i], q1 = n * d[i] - dot(axis, d) * axis[i];
    long j0 = n - dot(axis, w), j1 = -dot(axis, d);
    if (c->shape == SURE_SHAPE_SPHERE) {
        *out = (normal_component){.g0 = w[i], .g1 = d[i], .s0 = r, .n = 1};
    } else if (c->shape == SURE_SHAPE_CYLINDER) {
        *out = (normal_component){.g0 = q0, .g1 = q1, .s0 = n * r, .n = 1};
    } else {
        *out = (normal_component){.g0 = n * q0 + r * r * j0 * axis[i],
                                  .g1 = n * q1 + r * r * j1 * axis[i],
                                  .s0 = r * j0,
                                  .s1 = r * j1,
                                  .n = n * (n + r * r)};
    }
}

bool normal_nearest(const lattice_case *c, sure_part part, surd x, long root, int component,
                    double y)
{
    normal_component number = {.g0 = 0};
    int w[3];
    for (int i = 0; i < 3; i++)
        w[i] = c->origin[i] - c->anchor[i];
    bool flat = c->shape == SURE_SHAPE_PLANE || c->shape == SURE_SHAPE_DISC;
    bool pointed = c->shape == SURE_SHAPE_CONE && at_apex(c, w, x, root);
    if (flat || part == SURE_PART_TOP || pointed)
        constant_normal(&number, c->axis, 1, component);
    else if (part == SURE_PART_BASE)
        constant_normal(&number, c->axis, -1, component);
    else if (c->radius == 0)
        constant_normal(&number, c->direction, -1, component);
    else
        round_normal(&number, c, w, component);
    number.t = (rooted){x, root};
    return is_nearest(normal_excess, &number, y);
}
