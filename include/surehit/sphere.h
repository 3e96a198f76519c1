/* The solid sphere. */
#ifndef SUREHIT_SPHERE_H
#define SUREHIT_SPHERE_H

#include <surehit/answer.h>
#include <surehit/ray.h>
#include <surehit/shape.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    sure_vec3 centre; /* C: finite */
    double radius;    /* r: finite, >= 0; 0 makes the sphere a point */
} sure_sphere;

/* The first invalid field of ray or sphere, in the contract's order, or SURE_FIELD_NONE. */
sure_field sure_sphere_check(const sure_ray *ray, const sure_sphere *sphere);

/* First boundary point of the sphere on the ray (from inside, the far side; tangency is a hit).
 *
 * Entry    any values; what the contract calls invalid is answered SURE_INVALID.
 * Returns  SURE_HIT and *hit; SURE_MISS or SURE_INVALID and *hit untouched.
 * Bound    float32, textbook: status and t as their precision has them, t_error = +infinity.
 *          stable: where the first stage of certain is certain its answer, else a guess with
 *          t_error = +infinity. certain, exact: the status, the part and the end of the chord are
 *          right, always; certain: |t - t*| <= t_error, at most SURE_T_ERROR_CAP where a double can
 *          be; exact: t correctly rounded, in any rounding mode, t_error half an ulp.
 * Source   notes, "ray - sphere intersection".
 * Proof    docs/derivations/sphere.md, docs/proofs/stages.md; what the notes print wrong,
 *          docs/errata.md.
 * Laws     1 to 9 of <surehit/shape.h>. */
sure_status sure_sphere_hit_float32(const sure_ray *ray, const sure_sphere *sphere, sure_hit *hit);
sure_status sure_sphere_hit_textbook(const sure_ray *ray, const sure_sphere *sphere, sure_hit *hit);
sure_status sure_sphere_hit_stable(const sure_ray *ray, const sure_sphere *sphere, sure_hit *hit);
sure_status sure_sphere_hit_certain(const sure_ray *ray, const sure_sphere *sphere, sure_hit *hit);
sure_status sure_sphere_hit_exact(const sure_ray *ray, const sure_sphere *sphere, sure_hit *hit);

/* Both ends of the chord, for what lies beyond the first hit. SURE_HIT when the closed chord and
 * [t_min, t_max] have a point in common (the ray may then lie wholly inside, where
 * sure_sphere_hit_* says miss); otherwise as above. */
sure_status sure_sphere_interval_float32(const sure_ray *ray, const sure_sphere *sphere,
                                         sure_interval *interval);
sure_status sure_sphere_interval_textbook(const sure_ray *ray, const sure_sphere *sphere,
                                          sure_interval *interval);
sure_status sure_sphere_interval_stable(const sure_ray *ray, const sure_sphere *sphere,
                                        sure_interval *interval);
sure_status sure_sphere_interval_certain(const sure_ray *ray, const sure_sphere *sphere,
                                         sure_interval *interval);
sure_status sure_sphere_interval_exact(const sure_ray *ray, const sure_sphere *sphere,
                                       sure_interval *interval);

/* Is there a hit at all? The status of sure_sphere_hit_*, without its outputs. */
sure_status sure_sphere_occluded_float32(const sure_ray *ray, const sure_sphere *sphere);
sure_status sure_sphere_occluded_textbook(const sure_ray *ray, const sure_sphere *sphere);
sure_status sure_sphere_occluded_stable(const sure_ray *ray, const sure_sphere *sphere);
sure_status sure_sphere_occluded_certain(const sure_ray *ray, const sure_sphere *sphere);
sure_status sure_sphere_occluded_exact(const sure_ray *ray, const sure_sphere *sphere);

/* The outward unit normal at the hit; on a sphere of radius 0, -d/|d|.
 * Entry: ray and sphere as given to sure_sphere_hit_*, which answered SURE_HIT and *hit. */
sure_vec3 sure_sphere_normal_float32(const sure_ray *ray, const sure_sphere *sphere,
                                     const sure_hit *hit);
sure_vec3 sure_sphere_normal_textbook(const sure_ray *ray, const sure_sphere *sphere,
                                      const sure_hit *hit);
sure_vec3 sure_sphere_normal_stable(const sure_ray *ray, const sure_sphere *sphere,
                                    const sure_hit *hit);
sure_vec3 sure_sphere_normal_certain(const sure_ray *ray, const sure_sphere *sphere,
                                     const sure_hit *hit);
sure_vec3 sure_sphere_normal_exact(const sure_ray *ray, const sure_sphere *sphere,
                                   const sure_hit *hit);

#ifdef __cplusplus
}
#endif
#endif
