/* The errata of docs/errata.md that numbers can show, one test case an id: eNN() is the formula as
 * the notes print it, evaluated on the counterexample given there; then surehit's answer to the
 * same question. Wording errata have no test. */
#include "suite.h"

#include <math.h>
#include <stdio.h>

static const sure_vec3 nowhere = {0, 0, 0};
static const sure_vec3 up = {0, 0, 1};

static sure_vec3 plus(sure_vec3 a, sure_vec3 b)
{
    return (sure_vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static sure_vec3 times(double k, sure_vec3 v)
{
    return (sure_vec3){k * v.x, k * v.y, k * v.z};
}

static sure_vec3 minus(sure_vec3 a, sure_vec3 b)
{
    return plus(a, times(-1, b));
}

static double dot(sure_vec3 a, sure_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static double square(double x)
{
    return x * x;
}

static double length(sure_vec3 v)
{
    return sqrt(dot(v, v));
}

static sure_vec3 unit(sure_vec3 v)
{
    return (sure_vec3){v.x / length(v), v.y / length(v), v.z / length(v)};
}

static sure_ray ray_of(sure_vec3 o, sure_vec3 d)
{
    return (sure_ray){o, d, 0, INFINITY};
}

/* a t^2 + 2 half_b t + c = 0 */
typedef struct {
    double a, half_b, c;
} quadratic;

static double quarter(quadratic q)
{
    return q.half_b * q.half_b - q.a * q.c;
}

/* The root with this sign before the square root. */
static double root(quadratic q, int sign)
{
    return (-q.half_b + sign * sqrt(quarter(q))) / q.a;
}

/* Fails unless the value, rounded to four decimals, is written as in docs/errata.md. */
static void ck_reads(double value, const char *expected)
{
    char text[64];
    snprintf(text, sizeof text, "%.4f", value);
    ck_assert_str_eq(text, expected);
}

/* The pixel ray */

static sure_ray e01(sure_vec3 camera, sure_vec3 pixel)
{
    return ray_of(pixel, unit(minus(pixel, camera)));
}

START_TEST(test_e01)
{
    sure_sphere sphere = {{0, 0, -0.5}, 0.25};
    sure_camera camera = {nowhere, 1, 2, 2};
    sure_hit hit;
    sure_ray printed = e01(nowhere, (sure_vec3){0, 0, -1});
    ck_assert_int_eq(sure_sphere_hit_textbook(&printed, &sphere, &hit), SURE_MISS);
    sure_ray right = sure_pixel_ray_textbook(&camera, 1, 1, 0, 0);
    ck_assert_int_eq(sure_sphere_hit_textbook(&right, &sphere, &hit), SURE_HIT);
    ck_double_same(hit.t, 0.25);
}
END_TEST

static sure_vec3 e02(sure_vec3 camera, sure_vec3 pixel)
{
    return unit(minus(pixel, camera));
}

START_TEST(test_e02)
{
    sure_plane wall = {{0, 0, -8}, up};
    sure_camera camera = {nowhere, 4, 12, 12};
    sure_hit hit;
    sure_ray printed = ray_of(nowhere, e02(nowhere, (sure_vec3){3, 0, -4}));
    ck_assert_int_eq(sure_plane_hit_textbook(&printed, &wall, &hit), SURE_HIT);
    ck_double_same(hit.t, 10);
    sure_ray right = sure_pixel_ray_textbook(&camera, 2, 1, 1, 0);
    ck_vector_same(right.direction, (sure_vec3){3, 0, -4});
    ck_assert_int_eq(sure_plane_hit_textbook(&right, &wall, &hit), SURE_HIT);
    ck_double_same(hit.t, 2);
}
END_TEST

/* The bracket */

static double unit_sphere(const void *surface, sure_vec3 point)
{
    (void)surface;
    return dot(point, point) - 1;
}

/* Solid from x = 1 on. */
static double wall(const void *surface, sure_vec3 point)
{
    (void)surface;
    return 1 - point.x;
}

/* The first n with f(P_n) > 0 and f(P_n+1) < 0, or -1. */
static int e03(sure_implicit *f, const sure_ray *ray, int steps)
{
    for (int n = 0; n < steps; n++) {
        double here = f(NULL, plus(ray->origin, times(n, ray->direction)));
        double next = f(NULL, plus(ray->origin, times(n + 1, ray->direction)));
        if (here > 0 && next < 0)
            return n;
    }
    return -1;
}

START_TEST(test_e03)
{
    sure_ray ray = {{0, 0, 0}, {1, 0, 0}, 0, 2};
    double t[2];
    ck_assert_int_eq(e03(wall, &ray, 2), -1);
    ck_assert_int_eq(sure_bracket_textbook(wall, NULL, &ray, 2, t), SURE_HIT);
    ck_double_same(t[1], 1);
}
END_TEST

START_TEST(test_e04)
{
    sure_ray through = {{-2, 0, 0}, {4, 0, 0}, 0, 1};
    sure_sphere sphere = {nowhere, 1};
    sure_hit hit;
    double t[2];
    ck_assert_int_eq(e03(unit_sphere, &through, 1), -1);
    ck_assert_int_eq(sure_bracket_textbook(unit_sphere, NULL, &through, 1, t), SURE_MISS);
    ck_assert_int_eq(sure_sphere_hit_textbook(&through, &sphere, &hit), SURE_HIT);
    ck_double_same(hit.t, 0.25);
}
END_TEST

/* The Phong reflection model */

static sure_vec3 e05(sure_vec3 v, sure_vec3 n)
{
    return times(2, minus(times(dot(n, v) / dot(n, n), n), v));
}

START_TEST(test_e05)
{
    sure_vec3 v = {1, 0, 1};
    ck_vector_same(e05(v, up), (sure_vec3){-2, 0, 0});
    ck_vector_same(sure_reflect_textbook(v, up), (sure_vec3){-1, 0, 1});
}
END_TEST

/* The nearest formula to "closer": a power of R.L without a condition. */
static double e07(sure_vec3 r, sure_vec3 l, int shine)
{
    return pow(dot(r, l), shine);
}

START_TEST(test_e07)
{
    sure_vec3 below = {0, 0, -1};
    ck_double_same(e07(sure_reflect_textbook(up, up), below, 2), 1);
    ck_double_same(sure_phong_specular_textbook(up, up, below, 2), 0);
}
END_TEST

/* The viewport and its pixels */

static double e08(double focal_length, double fov)
{
    return 2 * focal_length * tan(fov / 2);
}

START_TEST(test_e08)
{
    ck_reads(e08(1, 4), "-4.3701");
    ck_reads(sure_viewport_extent_textbook(1, 4), "0.0698");
}
END_TEST

/* "viewport_low_left: a direction", from which P_camera is subtracted. */
static sure_vec3 e09(sure_vec3 low_left_direction, sure_vec3 camera)
{
    return minus(low_left_direction, camera);
}

START_TEST(test_e09)
{
    sure_camera camera = {{5, 0, 0}, 1, 4, 4};
    ck_vector_same(e09((sure_vec3){-1, -1, -1}, camera.position), (sure_vec3){-6, -1, -1});
    sure_ray right = sure_pixel_ray_textbook(&camera, 2, 2, 0, 0);
    ck_vector_same(right.direction, (sure_vec3){-1, -1, -1});
}
END_TEST

/* The scalars are added to every component of the point. */
static sure_vec3 e10(sure_vec3 low_left, double width, double u, double height, double v)
{
    double s = width * u + height * v;
    return plus(low_left, (sure_vec3){s, s, s});
}

START_TEST(test_e10)
{
    sure_camera camera = {nowhere, 1, 4, 4};
    ck_vector_same(e10((sure_vec3){-2, -2, -1}, 4, 0.75, 4, 0.25), (sure_vec3){2, 2, 3});
    sure_ray right = sure_pixel_ray_textbook(&camera, 2, 2, 1, 0);
    ck_vector_same(right.direction, (sure_vec3){1, -1, -1});
}
END_TEST

static double e11(int i, int screen_width)
{
    return (double)i / (screen_width - 1);
}

START_TEST(test_e11)
{
    sure_camera camera = {nowhere, 1, 4, 4};
    ck_assert(isnan(e11(0, 1)));
    ck_double_same(sure_pixel_ray_textbook(&camera, 1, 1, 0, 0).direction.x, 0);
}
END_TEST

/* Where the viewport, from -width/2 to width/2, is met. */
static double e12(double width, int i, int screen_width)
{
    return -width / 2 + width * e11(i, screen_width);
}

START_TEST(test_e12)
{
    sure_camera camera = {nowhere, 1, 3, 2};
    ck_double_same(e12(3, 0, 3), -1.5);
    ck_double_same(e12(3, 1, 3) - e12(3, 0, 3), 1.5);
    ck_double_same(e12(2, 1, 2) - e12(2, 0, 2), 2);
    sure_vec3 low_left = sure_pixel_ray_textbook(&camera, 3, 2, 0, 0).direction;
    sure_vec3 next = sure_pixel_ray_textbook(&camera, 3, 2, 1, 1).direction;
    ck_vector_same(low_left, (sure_vec3){-1, -0.5, -1});
    ck_vector_same(minus(next, low_left), (sure_vec3){1, 1, 0});
}
END_TEST

/* The sphere */

/* The last line of the derivation; rc is the centre's position there, the way to it from the ray's
 * origin in the corrected form. */
static quadratic sphere_quadratic(sure_vec3 rc, sure_vec3 d, double r)
{
    return (quadratic){dot(d, d), -dot(rc, d), dot(rc, rc) - r * r};
}

START_TEST(test_e14)
{
    sure_ray ray = ray_of((sure_vec3){0, 0, 5}, (sure_vec3){0, 0, -1});
    sure_sphere sphere = {{0, 0, 2}, 1};
    sure_hit hit;
    quadratic e14 = sphere_quadratic(sphere.centre, ray.direction, sphere.radius);
    ck_double_same(root(e14, -1), -3);
    ck_double_same(root(e14, +1), -1);
    ck_assert_int_eq(sure_sphere_hit_textbook(&ray, &sphere, &hit), SURE_HIT);
    ck_double_same(hit.t, 2);
}
END_TEST

/* "discriminant >= 0": a hit. */
static int e16(quadratic q)
{
    return quarter(q) >= 0;
}

START_TEST(test_e16)
{
    sure_ray ray = ray_of(nowhere, up);
    sure_sphere behind = {{0, 0, -3}, 1};
    sure_hit hit;
    quadratic q = sphere_quadratic(behind.centre, ray.direction, behind.radius);
    ck_assert(e16(q));
    ck_double_same(root(q, -1), -4);
    ck_double_same(root(q, +1), -2);
    ck_assert_int_eq(sure_sphere_hit_textbook(&ray, &behind, &hit), SURE_MISS);
}
END_TEST

START_TEST(test_e17)
{
    sure_ray ray = ray_of(nowhere, (sure_vec3){0, 0, -1});
    sure_sphere around = {nowhere, 1};
    sure_hit hit;
    double e17 = root(sphere_quadratic(around.centre, ray.direction, around.radius), -1);
    ck_double_same(e17, -1);
    ck_assert_int_eq(sure_sphere_hit_textbook(&ray, &around, &hit), SURE_HIT);
    ck_double_same(hit.t, 1);
}
END_TEST

/* (-(b/2)^2 +- sqrt(D/4)) / a, of the sphere (E18), the cylinder (E30) and the cone (E50). */
static double e18_e30_e50(quadratic q, int sign)
{
    return (-square(q.half_b) + sign * sqrt(quarter(q))) / q.a;
}

START_TEST(test_e18)
{
    sure_ray ray = ray_of(nowhere, (sure_vec3){0, 0, -1});
    sure_sphere sphere = {{0, 0, -3}, 1};
    sure_hit hit;
    quadratic q = sphere_quadratic(sphere.centre, ray.direction, sphere.radius);
    ck_double_same(e18_e30_e50(q, -1), -10);
    ck_double_same(e18_e30_e50(q, +1), -8);
    ck_assert_int_eq(sure_sphere_hit_textbook(&ray, &sphere, &hit), SURE_HIT);
    ck_double_same(hit.t, 2);
}
END_TEST

static sure_vec3 e19(sure_vec3 centre, sure_vec3 p_hit)
{
    return unit(minus(p_hit, centre));
}

START_TEST(test_e19)
{
    sure_ray ray = ray_of((sure_vec3){0, 0, 4}, (sure_vec3){0, 0, -2});
    sure_sphere point = {nowhere, 0};
    sure_hit hit;
    ck_assert(isnan(e19(nowhere, nowhere).z));
    ck_assert_int_eq(sure_sphere_hit_textbook(&ray, &point, &hit), SURE_HIT);
    ck_double_same(hit.t, 2);
    ck_vector_same(sure_sphere_normal_textbook(&ray, &point, &hit), up);
}
END_TEST

/* The plane */

/* ad + by + cz + d, with one d for x and for the constant. */
static double e20(sure_vec3 n, double d, double y, double z)
{
    return n.x * d + n.y * y + n.z * z + d;
}

START_TEST(test_e20)
{
    sure_plane plane = {{3, 0, 0}, {1, 0, 0}};
    sure_ray ray = ray_of(nowhere, (sure_vec3){1, 0, 0});
    sure_hit hit;
    ck_double_same(e20(plane.normal, -dot(plane.normal, plane.point), 0, 0), -6);
    ck_assert_int_eq(sure_plane_hit_textbook(&ray, &plane, &hit), SURE_HIT);
    ck_double_same(hit.t, 3);
}
END_TEST

static double e22(sure_vec3 n, sure_vec3 rc, sure_vec3 d)
{
    return dot(n, rc) / dot(n, d);
}

START_TEST(test_e22)
{
    sure_ray inside = {{1, 0, 0}, {0, 1, 0}, 2, INFINITY};
    sure_plane plane = {nowhere, up};
    sure_hit hit;
    ck_assert(isnan(e22(up, minus(plane.point, inside.origin), inside.direction)));
    ck_assert_int_eq(sure_plane_hit_textbook(&inside, &plane, &hit), SURE_HIT);
    ck_double_same(hit.t, 2);
}
END_TEST

/* N_hit = N, of the plane (E23, E24), the cylinder's bottom (E39) and the cone's base (E61). */
static sure_vec3 e23_e24_e39_e61(sure_vec3 n)
{
    return n;
}

START_TEST(test_e23)
{
    sure_plane plane = {nowhere, {0, 0, 2}};
    sure_ray ray = ray_of(up, (sure_vec3){0, 0, -1});
    sure_hit hit;
    ck_vector_same(e23_e24_e39_e61(plane.normal), (sure_vec3){0, 0, 2});
    ck_assert_int_eq(sure_plane_hit_textbook(&ray, &plane, &hit), SURE_HIT);
    ck_vector_same(sure_plane_normal_textbook(&ray, &plane, &hit), up);
}
END_TEST

START_TEST(test_e24)
{
    const sure_vec3 white = {1, 1, 1};
    sure_object away = {SURE_SHAPE_PLANE, {.plane = {{0, 0, -2}, {0, 0, -1}}}};
    sure_material matte = {.color = white};
    sure_light lamp = {nowhere, white, 1};
    sure_scene scene = {.objects = &away, .materials = &matte, .object_count = 1,
                        .lights = &lamp, .light_count = 1, .camera = {nowhere, 1, 1, 1},
                        .width = 1, .height = 1};
    sure_vec3 seen = {0, 0, -2}, normal = e23_e24_e39_e61(away.as.plane.normal);
    ck_double_same(sure_light_intensity_textbook(seen, normal, lamp.position), 0);
    ck_vector_same(sure_backward_pixel(&scene, SURE_TIER_TEXTBOOK, 0, 0), white);
}
END_TEST

/* The cylinder */

/* The last line, for the axis N as it is given, rc from the ray's origin to a point of the axis. */
static quadratic e25(sure_vec3 rc, sure_vec3 d, sure_vec3 n, double r)
{
    return (quadratic){dot(d, d) - square(dot(d, n)),
                       -(dot(rc, d) - dot(d, n) * dot(rc, n)),
                       dot(rc, rc) - square(dot(rc, n)) - r * r};
}

static void wall_hit_is(sure_vec3 o, sure_vec3 d, sure_vec3 base, sure_vec3 top, double t)
{
    sure_cylinder cylinder = {base, top, 1};
    sure_ray ray = ray_of(o, d);
    sure_hit hit;
    ck_assert_int_eq(sure_cylinder_wall_hit_textbook(&ray, &cylinder, &hit), SURE_HIT);
    ck_double_same(hit.t, t);
}

START_TEST(test_e14_cylinder)
{
    sure_vec3 o = {-3, 0, 0}, d = {1, 0, 0}, c = {1, 0, 0};
    ck_double_same(root(e25(c, d, up, 1), -1), 0);
    wall_hit_is(o, d, c, (sure_vec3){1, 0, 1}, 3);
}
END_TEST

START_TEST(test_e25)
{
    sure_vec3 o = {-3, 0, 1}, d = {1, 0, 0}, n = {0, 0, 2};
    ck_double_same(root(e25(minus(nowhere, o), d, n, 1), -1), 1);
    wall_hit_is(o, d, nowhere, n, 2);
}
END_TEST

/* ... + (rc.N)^2 - r^2 */
static quadratic e26(sure_vec3 rc, sure_vec3 d, sure_vec3 n, double r)
{
    quadratic q = e25(rc, d, n, r);
    q.c = dot(rc, rc) + square(dot(rc, n)) - r * r;
    return q;
}

START_TEST(test_e26)
{
    sure_vec3 d = {1, 0, 0}, c = {3, 0, 1};
    ck_double_same(quarter(e26(c, d, up, 1)), -1);
    wall_hit_is(nowhere, d, c, (sure_vec3){3, 0, 2}, 2);
}
END_TEST

/* - (rp.N)^2 - 2 (rp.N)(d.N) + (d.N)^2 + ..., rc the centre's position. */
static quadratic e28(sure_vec3 rp, sure_vec3 d, sure_vec3 rc, sure_vec3 n, double r)
{
    double c = dot(rp, rp) - 2 * dot(rc, rp) + dot(rc, rc) - square(dot(rp, n)) -
               2 * dot(rp, n) * dot(d, n) + square(dot(d, n)) + 2 * dot(rp, n) * dot(rc, n) -
               square(dot(rc, n)) - r * r;
    return (quadratic){dot(d, d), dot(rp, d) - dot(rc, d) + dot(d, n) * dot(rc, n), c};
}

START_TEST(test_e28)
{
    sure_vec3 o = {-3, 0, 1}, d = {1, 0, 1};
    ck_double_same(quarter(e28(o, d, nowhere, up, 1)), -10);
    wall_hit_is(o, d, nowhere, up, 2);
}
END_TEST

START_TEST(test_e29)
{
    sure_ray ray = ray_of((sure_vec3){0.5, 0, 5}, (sure_vec3){0, 0, -1});
    sure_cylinder cylinder = {nowhere, {0, 0, 2}, 1};
    sure_hit hit;
    double e29 = root(e25(minus(nowhere, ray.origin), ray.direction, up, 1), -1);
    ck_assert(isnan(e29));
    ck_assert_int_eq(sure_cylinder_hit_textbook(&ray, &cylinder, &hit), SURE_HIT);
    ck_double_same(hit.t, 3);
    ck_assert_int_eq(hit.part, SURE_PART_TOP);
}
END_TEST

START_TEST(test_e30)
{
    sure_vec3 o = {-3, 0, 0}, d = {1, 0, 0};
    quadratic q = e25(minus(nowhere, o), d, up, 1);
    ck_double_same(e18_e30_e50(q, -1), -10);
    ck_double_same(e18_e30_e50(q, +1), -8);
    wall_hit_is(o, d, nowhere, up, 2);
}
END_TEST

/* The left side of sqrt((x_n^2 + y_n^2 + z_n^2) t^2) = -h/2. */
static double e31(sure_vec3 n, double t)
{
    return sqrt(dot(n, n) * t * t);
}

START_TEST(test_e31)
{
    sure_cylinder cylinder;
    ck_double_same(e31(up, -1), 1);
    ck_assert_int_eq(sure_cylinder_from_axis_textbook(nowhere, up, 1, 2, &cylinder),
                     SURE_FIELD_NONE);
    ck_vector_same(cylinder.base, (sure_vec3){0, 0, -1});
}
END_TEST

/* pi/2 <= alpha < pi and 0 < beta <= pi/2: a right angle or more, and not along N. */
static int e32(sure_vec3 n, sure_vec3 from_top, sure_vec3 from_bottom)
{
    double alpha = acos(dot(n, from_top) / (length(n) * length(from_top)));
    double beta = acos(dot(n, from_bottom) / (length(n) * length(from_bottom)));
    return acos(0) <= alpha && alpha < acos(-1) && 0 < beta && beta <= acos(0);
}

START_TEST(test_e32)
{
    sure_cylinder segment = {nowhere, {0, 0, 2}, 0};
    sure_vec3 p_hit = {0, 0, 1};
    ck_assert(!e32(up, minus(p_hit, segment.top), minus(p_hit, segment.base)));
    ck_assert_int_eq(sure_cylinder_height_textbook(p_hit, &segment), 1);
}
END_TEST

static sure_vec3 e33(sure_vec3 bottom, sure_vec3 p_hit)
{
    return unit(minus(p_hit, bottom));
}

static sure_vec3 e34(sure_vec3 c, sure_vec3 n, sure_vec3 p, sure_vec3 p_hit)
{
    return unit(minus(p_hit, plus(c, times(dot(n, minus(p, c)) / dot(n, n), n))));
}

START_TEST(test_e33)
{
    sure_cylinder cylinder = {{0, 0, -1}, up, 1};
    sure_vec3 p_hit = {1, 0, 0};
    ck_reads(e33(cylinder.base, p_hit).x, "0.7071");
    ck_reads(e33(cylinder.base, p_hit).z, "0.7071");
    ck_vector_same(sure_cylinder_wall_normal_textbook(p_hit, &cylinder), (sure_vec3){1, 0, 0});
}
END_TEST

START_TEST(test_e34)
{
    sure_cylinder cylinder = {{0, 0, -1}, up, 1};
    sure_vec3 p_hit = {1, 0, 0};
    ck_reads(e34(nowhere, up, cylinder.top, p_hit).x, "0.7071");
    ck_reads(e34(nowhere, up, cylinder.top, p_hit).z, "-0.7071");
    ck_vector_same(sure_cylinder_wall_normal_textbook(p_hit, &cylinder), (sure_vec3){1, 0, 0});
}
END_TEST

/* C + h/2 sqrt(1/x_n^2 + y_n^2 + z_n^2) N */
static sure_vec3 e35(sure_vec3 c, sure_vec3 n, double h)
{
    return plus(c, times(h / 2 * sqrt(1 / square(n.x) + square(n.y) + square(n.z)), n));
}

START_TEST(test_e35)
{
    sure_vec3 n = {1, 2, 2};
    sure_cylinder cylinder;
    ck_vector_same(e35(nowhere, n, 6), (sure_vec3){9, 18, 18});
    ck_assert_int_eq(sure_cylinder_from_axis_textbook(nowhere, n, 1, 6, &cylinder),
                     SURE_FIELD_NONE);
    ck_vector_same(cylinder.top, n);
}
END_TEST

/* N.rQ / N.rcy, the only symbol like it being rc */
static double e36(sure_vec3 n, sure_vec3 rq, sure_vec3 rc)
{
    return dot(n, rq) / dot(n, rc);
}

START_TEST(test_e36)
{
    sure_ray ray = ray_of((sure_vec3){0, 0, 5}, (sure_vec3){0, 0, -1});
    sure_cylinder cylinder = {{0, 0, -1}, up, 1};
    sure_hit hit;
    ck_double_same(e36(up, minus(up, ray.origin), minus(nowhere, ray.origin)), 0.8);
    ck_assert_int_eq(sure_cylinder_hit_textbook(&ray, &cylinder, &hit), SURE_HIT);
    ck_double_same(hit.t, 4);
}
END_TEST

START_TEST(test_e38)
{
    sure_ray ray = ray_of((sure_vec3){-3, 0, 0}, (sure_vec3){1, 0, 0});
    sure_disc disc = {nowhere, up, 1};
    sure_hit hit;
    double e38 = e22(up, minus(nowhere, ray.origin), ray.direction);
    ck_assert(isnan(e38));
    ck_assert_int_eq(sure_disc_hit_textbook(&ray, &disc, &hit), SURE_HIT);
    ck_double_same(hit.t, 2);
}
END_TEST

START_TEST(test_e39)
{
    sure_ray ray = ray_of((sure_vec3){0, 0, -5}, up);
    sure_cylinder cylinder = {nowhere, {0, 0, 2}, 1};
    sure_hit hit;
    ck_vector_same(e23_e24_e39_e61(up), up);
    ck_assert_int_eq(sure_cylinder_hit_textbook(&ray, &cylinder, &hit), SURE_HIT);
    ck_assert_int_eq(hit.part, SURE_PART_BASE);
    ck_vector_same(sure_cylinder_normal_textbook(&ray, &cylinder, &hit), (sure_vec3){0, 0, -1});
}
END_TEST

/* The nearer of the circles that are hit. */
static double e41(const sure_ray *ray, const sure_cylinder *cylinder)
{
    sure_vec3 n = minus(cylinder->top, cylinder->base), ends[] = {cylinder->top, cylinder->base};
    double nearest = INFINITY;
    for (int i = 0; i < 2; i++) {
        double t = e22(n, minus(ends[i], ray->origin), ray->direction);
        sure_vec3 p_hit = plus(ray->origin, times(t, ray->direction));
        if (length(minus(p_hit, ends[i])) <= cylinder->radius)
            nearest = fmin(nearest, t);
    }
    return nearest;
}

START_TEST(test_e41)
{
    sure_ray ray = ray_of((sure_vec3){-3, 0, 3}, (sure_vec3){1, 0, -1});
    sure_cylinder cylinder = {nowhere, {0, 0, 2}, 1};
    sure_hit hit;
    ck_double_same(e41(&ray, &cylinder), 3);
    ck_assert_int_eq(sure_cylinder_hit_textbook(&ray, &cylinder, &hit), SURE_HIT);
    ck_double_same(hit.t, 2);
    ck_assert_int_eq(hit.part, SURE_PART_WALL);
}
END_TEST

/* The cone: base at the origin, apex at (0,0,1), radius 1, so that cos^2 is 1/2 */

static const sure_cone right_angled = {{0, 0, 0}, {0, 0, 1}, 1};
static const double cos2 = 0.5;

/* The last line, for |N| = 1 and rq from the ray's origin to the apex. */
static quadratic cone_quadratic(sure_vec3 rq, sure_vec3 d, sure_vec3 n, double cos_square)
{
    return (quadratic){square(dot(d, n)) - dot(d, d) * cos_square,
                       -(dot(rq, n) * dot(n, d) - dot(rq, d) * cos_square),
                       square(dot(rq, n)) - dot(rq, rq) * cos_square};
}

static void cone_hit_is(sure_vec3 o, sure_vec3 d, const sure_cone *cone, double t)
{
    sure_ray ray = ray_of(o, d);
    sure_hit hit;
    ck_assert_int_eq(sure_cone_hit_textbook(&ray, cone, &hit), SURE_HIT);
    ck_double_same(hit.t, t);
}

static const sure_vec3 beside = {3, 0, 0}, inward = {-1, 0, 0};
static const sure_vec3 above = {0.5, 0, 10}, down = {0, 0, -1};

/* The nearer root, dropped when it is on the other nappe. */
static double e43(quadratic q, double depth_at_origin, double depth_step)
{
    double t = fmin(root(q, -1), root(q, +1));
    return depth_at_origin + t * depth_step >= 0 ? t : INFINITY;
}

START_TEST(test_e43)
{
    sure_vec3 rq = minus(right_angled.apex, above);
    quadratic q = cone_quadratic(rq, down, up, cos2);
    ck_double_same(root(q, -1), 8.5);
    ck_double_same(e43(q, dot(up, rq), -dot(up, down)), INFINITY);
    cone_hit_is(above, down, &right_angled, 9.5);
}
END_TEST

/* -2 (rq.N) ray(t), where a number is wanted. */
static sure_vec3 e44(sure_vec3 rq, sure_vec3 n, sure_vec3 point)
{
    return times(-2 * dot(rq, n), point);
}

START_TEST(test_e44)
{
    sure_vec3 rim = {1, 0, 0};
    ck_vector_same(e44(right_angled.apex, up, rim), (sure_vec3){-2, 0, 0});
    ck_double_same(-2 * dot(right_angled.apex, up) * dot(rim, up), 0);
    cone_hit_is(beside, inward, &right_angled, 2);
}
END_TEST

/* The expanded equation, rq the apex's position; square_term stands for the constant part of
 * (ray(t).N)^2, cross_term for that of 2 rq.ray(t). */
static quadratic expanded(sure_vec3 rp, sure_vec3 d, sure_vec3 rq, double square_term,
                          double cross_term)
{
    double q_n = dot(rq, up), p_n = dot(rp, up), d_n = dot(d, up);
    return (quadratic){square(d_n) - dot(d, d) * cos2,
                       -q_n * d_n + p_n * d_n + (dot(rq, d) - dot(rp, d)) * cos2,
                       square(q_n) - 2 * q_n * p_n + square_term -
                           (dot(rq, rq) - cross_term + dot(rp, rp)) * cos2};
}

/* (rq.N)^2 - 2 (rq.N) ray.N + ray^2 (N.N) - {rq.rq - 2 rq.ray + ray^2} cos^2 */
static quadratic e45(sure_vec3 rp, sure_vec3 d, sure_vec3 rq)
{
    quadratic q = expanded(rp, d, rq, dot(rp, rp), 2 * dot(rq, rp));
    q.a += dot(d, d) - square(dot(d, up));
    q.half_b += dot(rp, d) - dot(rp, up) * dot(d, up);
    return q;
}

START_TEST(test_e45)
{
    ck_double_same(quarter(e45(beside, inward, right_angled.apex)), -0.25);
    cone_hit_is(beside, inward, &right_angled, 2);
}
END_TEST

static quadratic e46(sure_vec3 rp, sure_vec3 d, sure_vec3 rq)
{
    return expanded(rp, d, rq, dot(rp, rp), 2 * dot(rq, rp));
}

START_TEST(test_e46)
{
    quadratic printed = e46(beside, inward, right_angled.apex);
    ck_reads(root(printed, +1), "-1.3589");
    ck_reads(root(printed, -1), "7.3589");
    cone_hit_is(beside, inward, &right_angled, 2);
}
END_TEST

static quadratic e47(sure_vec3 rp, sure_vec3 d, sure_vec3 rq)
{
    return expanded(rp, d, rq, square(dot(rp, up)), 2 * dot(rp, up));
}

START_TEST(test_e47)
{
    sure_cone cone = {nowhere, {0, 0, 2}, 2};
    sure_vec3 o = {3, 0, 1};
    ck_double_same(quarter(e47(o, inward, cone.apex)), -0.25);
    cone_hit_is(o, inward, &cone, 2);
}
END_TEST

/* All terms with r_p struck out, rq still the apex's position. */
static quadratic e48(sure_vec3 d, sure_vec3 rq)
{
    return cone_quadratic(rq, d, up, cos2);
}

START_TEST(test_e48)
{
    quadratic printed = e48(inward, right_angled.apex);
    ck_double_same(root(printed, +1), -1);
    ck_double_same(root(printed, -1), 1);
    cone_hit_is(beside, inward, &right_angled, 2);
}
END_TEST

/* (-1 - 2 {...} +- sqrt(D)) / 2a */
static double e49(quadratic q, int sign)
{
    return (-1 - 2 * -q.half_b + sign * 2 * sqrt(quarter(q))) / (2 * q.a);
}

START_TEST(test_e49)
{
    quadratic q = cone_quadratic(minus(right_angled.apex, beside), inward, up, cos2);
    ck_double_same(e49(q, +1), -3);
    ck_double_same(e49(q, -1), -1);
    cone_hit_is(beside, inward, &right_angled, 2);
}
END_TEST

START_TEST(test_e50)
{
    quadratic q = cone_quadratic(minus(right_angled.apex, beside), inward, up, cos2);
    ck_double_same(e18_e30_e50(q, +1), 3.5);
    ck_double_same(e18_e30_e50(q, -1), 5.5);
    cone_hit_is(beside, inward, &right_angled, 2);
}
END_TEST

START_TEST(test_e51)
{
    quadratic q = cone_quadratic(minus(right_angled.apex, beside), inward, up, cos2);
    double e51 = root(q, -1);
    ck_double_same(e51, 4);
    cone_hit_is(beside, inward, &right_angled, 2);
}
END_TEST

START_TEST(test_e52)
{
    sure_vec3 o = {-1, 0, 1}, along = {1, 0, -1};
    quadratic q = cone_quadratic(minus(right_angled.apex, o), along, up, cos2);
    double e52 = root(q, +1);
    ck_assert(isnan(e52));
    cone_hit_is(o, along, &right_angled, 0.5);
}
END_TEST

/* |PQ| <= sqrt(r^2 + h^2) and rq.PQ >= 0 */
static int e53(sure_vec3 rq, sure_vec3 pq, double r, double h)
{
    return length(pq) <= sqrt(r * r + h * h) && dot(rq, pq) >= 0;
}

START_TEST(test_e53)
{
    sure_vec3 rq = minus(right_angled.apex, above);
    sure_vec3 high = {0.5, 0, 1.5}, low = {0.5, 0, 0.5};
    ck_assert(e53(rq, minus(right_angled.apex, high), 1, 1));
    ck_assert(!e53(rq, minus(right_angled.apex, low), 1, 1));
    ck_assert_int_eq(sure_cone_height_textbook(high, &right_angled), 0);
    ck_assert_int_eq(sure_cone_height_textbook(low, &right_angled), 1);
}
END_TEST

/* Height 4, radius 3, so that the slant is 5 and the cosine 4/5 */
static const sure_cone pointed = {{0, 0, 0}, {0, 0, 4}, 3};
static const sure_vec3 half_way = {1.5, 0, 2};

static sure_vec3 e54(sure_vec3 q, sure_vec3 p_hit, double cosine)
{
    return unit(plus(q, times(length(minus(q, p_hit)) / cosine, up)));
}

static sure_vec3 e55(sure_vec3 q, sure_vec3 p_hit, double cosine)
{
    return unit(minus(p_hit, plus(q, times(length(minus(q, p_hit)) / cosine, up))));
}

static sure_vec3 e56(sure_vec3 bottom, sure_vec3 p_hit)
{
    return unit(minus(p_hit, bottom));
}

START_TEST(test_e54)
{
    ck_vector_same(e54(pointed.apex, half_way, 0.8), up);
    ck_vector_same(sure_cone_wall_normal_textbook(half_way, &pointed), (sure_vec3){0.8, 0, 0.6});
}
END_TEST

START_TEST(test_e55)
{
    ck_reads(e55(pointed.apex, half_way, 0.8).x, "0.2809");
    ck_reads(e55(pointed.apex, half_way, 0.8).z, "-0.9597");
    ck_vector_same(sure_cone_wall_normal_textbook(half_way, &pointed), (sure_vec3){0.8, 0, 0.6});
}
END_TEST

START_TEST(test_e56)
{
    ck_vector_same(e56(pointed.base, half_way), (sure_vec3){0.6, 0, 0.8});
    ck_vector_same(sure_cone_wall_normal_textbook(half_way, &pointed), (sure_vec3){0.8, 0, 0.6});
}
END_TEST

/* P - S with S = Q - |PQ| / cos N, at the apex */
static sure_vec3 e57(sure_vec3 q, sure_vec3 p_hit, double cosine)
{
    return unit(minus(p_hit, minus(q, times(length(minus(q, p_hit)) / cosine, up))));
}

START_TEST(test_e57)
{
    ck_assert(isnan(e57(pointed.apex, pointed.apex, 0.8).z));
    ck_vector_same(sure_cone_wall_normal_textbook(pointed.apex, &pointed), up);
}
END_TEST

/* The first coordinate of B, d_c - h/2 sqrt(1/d_n^2 + n^2 + z_n^2) d_n, n read as |N|. */
static double e59(double d_c, sure_vec3 n, double h)
{
    return d_c - h / 2 * sqrt(1 / square(n.x) + dot(n, n) + square(n.z)) * n.x;
}

START_TEST(test_e59)
{
    sure_vec3 n = {1, 2, 2};
    sure_cone cone;
    ck_reads(e59(0, n, 6), "-11.2250");
    ck_assert_int_eq(sure_cone_from_axis_textbook(nowhere, n, 1, 6, &cone), SURE_FIELD_NONE);
    ck_vector_same(cone.base, (sure_vec3){-1, -2, -2});
}
END_TEST

static double e60(sure_vec3 n, sure_vec3 pb, sure_vec3 d)
{
    return dot(n, pb) / dot(n, d);
}

START_TEST(test_e60)
{
    sure_vec3 o = {0.25, 0, -5}, p_hit = {0.25, 0, 0};
    ck_double_same(e60(up, minus(right_angled.base, p_hit), up), 0);
    cone_hit_is(o, up, &right_angled, 5);
}
END_TEST

START_TEST(test_e61)
{
    sure_ray ray = ray_of((sure_vec3){0.25, 0, -5}, up);
    sure_hit hit;
    ck_vector_same(e23_e24_e39_e61(up), up);
    ck_assert_int_eq(sure_cone_hit_textbook(&ray, &right_angled, &hit), SURE_HIT);
    ck_assert_int_eq(hit.part, SURE_PART_BASE);
    ck_vector_same(sure_cone_normal_textbook(&ray, &right_angled, &hit), down);
}
END_TEST

START_TEST(test_e62)
{
    sure_vec3 o = {0.25, 0, -5};
    quadratic q = cone_quadratic(minus(right_angled.apex, o), up, up, cos2);
    double e62 = root(q, -1);
    ck_double_same(e62, 5.75);
    cone_hit_is(o, up, &right_angled, 5);
}
END_TEST

/* The light */

/* The cosine of the angle between light_direction = P_hit - P_light and N. */
static double e63(sure_vec3 p_hit, sure_vec3 n, sure_vec3 p_light)
{
    return dot(unit(minus(p_hit, p_light)), n);
}

static const sure_vec3 overhead = {0, 0, 2}, below = {0, 0, -2};

START_TEST(test_e63)
{
    ck_double_same(e63(nowhere, up, overhead), -1);
    ck_double_same(e63(nowhere, up, below), 1);
    ck_double_same(sure_light_intensity_textbook(nowhere, up, overhead), 1);
    ck_double_same(sure_light_intensity_textbook(nowhere, up, below), 0);
}
END_TEST

/* The angle itself, after the sign is mended. */
static double e64(sure_vec3 p_hit, sure_vec3 n, sure_vec3 p_light)
{
    return acos(-e63(p_hit, n, p_light));
}

START_TEST(test_e64)
{
    ck_double_same(e64(nowhere, up, overhead), 0);
    ck_double_same(sure_light_intensity_textbook(nowhere, up, overhead), 1);
}
END_TEST

/* The cosine without a lower end, after the sign is mended. */
static double e65(sure_vec3 p_hit, sure_vec3 n, sure_vec3 p_light)
{
    return -e63(p_hit, n, p_light);
}

START_TEST(test_e65)
{
    ck_double_same(e65(nowhere, up, below), -1);
    ck_double_same(sure_light_intensity_textbook(nowhere, up, below), 0);
}
END_TEST

static double e66(double rgb, double brightness, double distance)
{
    return rgb * brightness / (4 * acos(-1) * distance * distance);
}

START_TEST(test_e66)
{
    sure_light lamp = {nowhere, {1, 1, 1}, 1};
    ck_double_same(e66(1, 1, 0), INFINITY);
    ck_vector_same(sure_light_color_textbook(&lamp, nowhere, SURE_FALLOFF_INVERSE_SQUARE),
                   nowhere);
    ck_double_same(sure_light_intensity_textbook(nowhere, up, nowhere), 0);
}
END_TEST

/* "without hitting other objects" */
static int e67(const sure_ray *way, const sure_scene *scene, size_t own)
{
    for (size_t i = 0; i < scene->object_count; i++) {
        if (i != own &&
            sure_object_occluded(way, &scene->objects[i], SURE_TIER_TEXTBOOK) == SURE_HIT)
            return 0;
    }
    return 1;
}

START_TEST(test_e67)
{
    sure_object sphere = {SURE_SHAPE_SPHERE, {.sphere = {nowhere, 1}}};
    sure_scene scene = {.objects = &sphere, .object_count = 1};
    sure_surface_point inside = {0, {0, 0, -1}, {0, 0, 1}, 1};
    sure_vec3 lamp = {0, 0, 5};
    sure_ray way = {inside.point, minus(lamp, inside.point), 0, 1};
    ck_assert_int_eq(e67(&way, &scene, 0), 1);
    ck_assert_int_eq(sure_shadow_reaches(&scene, SURE_TIER_TEXTBOOK, &inside, lamp), 0);
}
END_TEST

/* The camera */

typedef struct {
    double c, s;
} turn;

static sure_mat3 world_for(sure_vec3 view)
{
    sure_mat3 world;
    ck_assert_int_eq(sure_camera_rotation_textbook(view, &world), SURE_HIT);
    return world;
}

/* R_z by 3 pi / 2 */
static sure_vec3 e68(sure_vec3 v)
{
    turn r = {0, -1};
    return (sure_vec3){r.c * v.x - r.s * v.y, r.s * v.x + r.c * v.y, v.z};
}

START_TEST(test_e68)
{
    sure_vec3 view = {0, 1, 0};
    ck_vector_same(e68(view), (sure_vec3){1, 0, 0});
    sure_mat3 world = world_for(view);
    ck_vector_same(sure_rotation_apply_textbook(&world, view), (sure_vec3){0, 0, -1});
}
END_TEST

/* Case 7, y < 0 and z < 0: cos = y / sqrt(y^2 + z^2), sin = sqrt(1 - cos^2). */
static turn e69(double y, double z)
{
    double c = y / sqrt(y * y + z * z);
    return (turn){c, sqrt(1 - c * c)};
}

START_TEST(test_e69)
{
    turn printed = e69(-3, -4);
    ck_double_same(printed.c, -0.6);
    ck_double_same(printed.s, 0.8);
    sure_mat3 world = world_for((sure_vec3){0, -3, -4});
    ck_vector_same(world.row[1], (sure_vec3){0, 0.8, -0.6});
    ck_vector_same(world.row[2], (sure_vec3){0, 0.6, 0.8});
}
END_TEST

/* The sine of case 7 with the cosine mended. */
static double e70(double y, double z)
{
    double c = fabs(z) / sqrt(y * y + z * z);
    return sqrt(1 - c * c);
}

START_TEST(test_e70)
{
    ck_double_same(e70(-0x1p-30, -1), 0);
    sure_mat3 world = world_for((sure_vec3){0, -0x1p-30, -1});
    ck_double_same(world.row[2].y, 0x1p-30);
}
END_TEST

/* Where case 7, y > 0 and z > 0, takes the world's up, (0, 1, 0): -cos, -sin, the cosine mended. */
static sure_vec3 e71(double y, double z)
{
    double across = sqrt(y * y + z * z);
    return (sure_vec3){0, -fabs(z) / across, -fabs(y) / across};
}

START_TEST(test_e71)
{
    ck_vector_same(e71(3, 4), (sure_vec3){0, -0.8, -0.6});
    sure_mat3 world = world_for((sure_vec3){0, 3, 4});
    ck_vector_same(sure_rotation_apply_textbook(&world, (sure_vec3){0, 1, 0}),
                   (sure_vec3){0, 0.8, -0.6});
}
END_TEST

/* Case 8, x > 0 and z < 0: cos = z / sqrt(x^2 + z^2). */
static double e72(double x, double z)
{
    return z / sqrt(x * x + z * z);
}

START_TEST(test_e72)
{
    ck_double_same(e72(3, -4), -0.8);
    sure_mat3 world = world_for((sure_vec3){3, 0, -4});
    ck_vector_same(world.row[0], (sure_vec3){0.8, 0, 0.6});
}
END_TEST

/* Case 8, x > 0 and z > 0: cos, -sin. */
static turn e73(double x, double z)
{
    double across = sqrt(x * x + z * z);
    return (turn){fabs(z) / across, -fabs(x) / across};
}

START_TEST(test_e73)
{
    turn printed = e73(3, 4);
    ck_double_same(printed.c, 0.8);
    ck_double_same(printed.s, -0.6);
    sure_mat3 world = world_for((sure_vec3){3, 0, 4});
    ck_vector_same(world.row[0], (sure_vec3){-0.8, 0, 0.6});
}
END_TEST

/* Case 7 is the nearest for x != 0: a turn about x alone. */
static double e74(sure_vec3 view)
{
    return view.x;
}

START_TEST(test_e74)
{
    sure_vec3 view = {3, 12, -4};
    ck_double_same(e74(view), 3);
    sure_mat3 world = world_for(view);
    ck_vector_same(world.row[0], (sure_vec3){0.8, 0, 0.6});
    ck_double_same(world.row[1].y, 5.0 / 13);
    ck_double_same(world.row[2].y, -12.0 / 13);
}
END_TEST

static void add(Suite *suite, const char *id, const TTest *test)
{
    TCase *erratum = tcase_create(id);
    tcase_add_test(erratum, test);
    suite_add_tcase(suite, erratum);
}

int main(void)
{
    Suite *suite = suite_create("errata");
    add(suite, "E01", test_e01);
    add(suite, "E02", test_e02);
    add(suite, "E03", test_e03);
    add(suite, "E04", test_e04);
    add(suite, "E05", test_e05);
    add(suite, "E07", test_e07);
    add(suite, "E08", test_e08);
    add(suite, "E09", test_e09);
    add(suite, "E10", test_e10);
    add(suite, "E11", test_e11);
    add(suite, "E12", test_e12);
    add(suite, "E14", test_e14);
    add(suite, "E14", test_e14_cylinder);
    add(suite, "E16", test_e16);
    add(suite, "E17", test_e17);
    add(suite, "E18", test_e18);
    add(suite, "E19", test_e19);
    add(suite, "E20", test_e20);
    add(suite, "E22", test_e22);
    add(suite, "E23", test_e23);
    add(suite, "E24", test_e24);
    add(suite, "E25", test_e25);
    add(suite, "E26", test_e26);
    add(suite, "E28", test_e28);
    add(suite, "E29", test_e29);
    add(suite, "E30", test_e30);
    add(suite, "E31", test_e31);
    add(suite, "E32", test_e32);
    add(suite, "E33", test_e33);
    add(suite, "E34", test_e34);
    add(suite, "E35", test_e35);
    add(suite, "E36", test_e36);
    add(suite, "E38", test_e38);
    add(suite, "E39", test_e39);
    add(suite, "E41", test_e41);
    add(suite, "E43", test_e43);
    add(suite, "E44", test_e44);
    add(suite, "E45", test_e45);
    add(suite, "E46", test_e46);
    add(suite, "E47", test_e47);
    add(suite, "E48", test_e48);
    add(suite, "E49", test_e49);
    add(suite, "E50", test_e50);
    add(suite, "E51", test_e51);
    add(suite, "E52", test_e52);
    add(suite, "E53", test_e53);
    add(suite, "E54", test_e54);
    add(suite, "E55", test_e55);
    add(suite, "E56", test_e56);
    add(suite, "E57", test_e57);
    add(suite, "E59", test_e59);
    add(suite, "E60", test_e60);
    add(suite, "E61", test_e61);
    add(suite, "E62", test_e62);
    add(suite, "E63", test_e63);
    add(suite, "E64", test_e64);
    add(suite, "E65", test_e65);
    add(suite, "E66", test_e66);
    add(suite, "E67", test_e67);
    add(suite, "E68", test_e68);
    add(suite, "E69", test_e69);
    add(suite, "E70", test_e70);
    add(suite, "E71", test_e71);
    add(suite, "E72", test_e72);
    add(suite, "E73", test_e73);
    add(suite, "E74", test_e74);
    return suite_run(suite);
}
