/* The solid capped cylinder, stored by its two end points so that all but one root is rational. */
#ifndef SUREHIT_CYLINDER_H
#define SUREHIT_CYLINDER_H

#include <surehit/answer.h>
#include <surehit/ray.h>
#include <surehit/shape.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    sure_vec3 base; /* centre of the base cap: finite */
    sure_vec3 top;  /* centre of the top cap: finite, differs from base */
    double radius;  /* r: finite, >= 0; 0 makes the cylinder a segment */
} sure_cylinder;

/* The first invalid field of ray or cylinder, in the contract's order, or SURE_FIELD_NONE. */
sure_field sure_cylinder_check(const sure_ray *ray, const sure_cylinder *cylinder);

/* First boundary point of the cylinder on the ray (wall and both caps, decided by the interval that
 * the body and the end planes leave).
 *
 * Entry    any values; what the contract calls invalid is answered SURE_INVALID.
 * Returns  SURE_HIT and *hit; SURE_MISS or SURE_INVALID and *hit untouched.
 * Bound    float32, textbook: status and t as their precision has them, t_error = +infinity.
 *          stable: where the first stage of certain is certain its answer, else a guess with
 *          t_error = +infinity. certain, exact: the status, the part and the end of the chord are
 *          right, always; certain: |t - t*| <= t_error, at most SURE_T_ERROR_CAP where a double can
 *          be; exact: t correctly rounded, in any rounding mode, t_error half an ulp.
 * Source   notes, "ray - cylinder intersection".
 * Proof    docs/derivations/cylinder.md, docs/proofs/stages.md; what the notes print wrong,
 *          docs/errata.md.
 * Laws     1 to 9 of <surehit/shape.h>. */
sure_status sure_cylinder_hit_float32(const sure_ray *ray, const sure_cylinder *cylinder,
                                      sure_hit *hit);
sure_status sure_cylinder_hit_textbook(const sure_ray *ray, const sure_cylinder *cylinder,
                                       sure_hit *hit);
sure_status sure_cylinder_hit_stable(const sure_ray *ray, const sure_cylinder *cylinder,
                                     sure_hit *hit);
sure_status sure_cylinder_hit_certain(const sure_ray *ray, const sure_cylinder *cylinder,
                                      sure_hit *hit);
sure_status sure_cylinder_hit_exact(const sure_ray *ray, const sure_cylinder *cylinder,
                                    sure_hit *hit);

/* Both ends of the chord, for what lies beyond the first hit. SURE_HIT when the closed chord and
 * [t_min, t_max] have a point in common (the ray may then lie wholly inside, where
 * sure_cylinder_hit_* says miss); otherwise as above. */
sure_status sure_cylinder_interval_float32(const sure_ray *ray, const sure_cylinder *cylinder,
                                           sure_interval *interval);
sure_status sure_cylinder_interval_textbook(const sure_ray *ray, const sure_cylinder *cylinder,
                                            sure_interval *interval);
sure_status sure_cylinder_interval_stable(const sure_ray *ray, const sure_cylinder *cylinder,
                                          sure_interval *interval);
sure_status sure_cylinder_interval_certain(const sure_ray *ray, const sure_cylinder *cylinder,
                                           sure_interval *interval);
sure_status sure_cylinder_interval_exact(const sure_ray *ray, const sure_cylinder *cylinder,
                                         sure_interval *interval);

/* Is there a hit at all? The status of sure_cylinder_hit_*, without its outputs. */
sure_status sure_cylinder_occluded_float32(const sure_ray *ray, const sure_cylinder *cylinder);
sure_status sure_cylinder_occluded_textbook(const sure_ray *ray, const sure_cylinder *cylinder);
sure_status sure_cylinder_occluded_stable(const sure_ray *ray, const sure_cylinder *cylinder);
sure_status sure_cylinder_occluded_certain(const sure_ray *ray, const sure_cylinder *cylinder);
sure_status sure_cylinder_occluded_exact(const sure_ray *ray, const sure_cylinder *cylinder);

/* The outward unit normal of hit->part; on a wall of radius 0, -d/|d|.
 * Entry: ray and cylinder as given to sure_cylinder_hit_*, which answered SURE_HIT and *hit. */
sure_vec3 sure_cylinder_normal_float32(const sure_ray *ray, const sure_cylinder *cylinder,
                                       const sure_hit *hit);
sure_vec3 sure_cylinder_normal_textbook(const sure_ray *ray, const sure_cylinder *cylinder,
                                        const sure_hit *hit);
sure_vec3 sure_cylinder_normal_stable(const sure_ray *ray, const sure_cylinder *cylinder,
                                      const sure_hit *hit);
sure_vec3 sure_cylinder_normal_certain(const sure_ray *ray, const sure_cylinder *cylinder,
                                       const sure_hit *hit);
sure_vec3 sure_cylinder_normal_exact(const sure_ray *ray, const sure_cylinder *cylinder,
                                     const sure_hit *hit);

#ifdef __cplusplus
}
#endif
#endif
