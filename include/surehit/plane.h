/* The infinite plane. */
#ifndef SUREHIT_PLANE_H
#define SUREHIT_PLANE_H

#include <surehit/answer.h>
#include <surehit/ray.h>
#include <surehit/shape.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    sure_vec3 point;  /* Q: finite, any point of the plane */
    sure_vec3 normal; /* N: finite, not zero, of any length */
} sure_plane;

/* The first invalid field of ray or plane, in the contract's order, or SURE_FIELD_NONE. */
sure_field sure_plane_check(const sure_ray *ray, const sure_plane *plane);

/* First boundary point of the plane on the ray (the set itself; a ray inside the plane hits at
 * t_min).
 *
 * Entry    any values; what the contract calls invalid is answered SURE_INVALID.
 * Returns  SURE_HIT and *hit; SURE_MISS or SURE_INVALID and *hit untouched.
 * Bound    float32, textbook: status and t as their precision has them, t_error = +infinity.
 *          stable: where the first stage of certain is certain its answer, else a guess with
 *          t_error = +infinity. certain, exact: the status, the part and the end of the chord are
 *          right, always; certain: |t - t*| <= t_error, at most SURE_T_ERROR_CAP where a double can
 *          be; exact: t correctly rounded, in any rounding mode, t_error half an ulp.
 * Source   notes, "ray-plane intersection".
 * Proof    docs/derivations/plane.md, docs/proofs/stages.md; what the notes print wrong,
 *          docs/errata.md.
 * Laws     1 to 9 of <surehit/shape.h>. */
sure_status sure_plane_hit_float32(const sure_ray *ray, const sure_plane *plane, sure_hit *hit);
sure_status sure_plane_hit_textbook(const sure_ray *ray, const sure_plane *plane, sure_hit *hit);
sure_status sure_plane_hit_stable(const sure_ray *ray, const sure_plane *plane, sure_hit *hit);
sure_status sure_plane_hit_certain(const sure_ray *ray, const sure_plane *plane, sure_hit *hit);
sure_status sure_plane_hit_exact(const sure_ray *ray, const sure_plane *plane, sure_hit *hit);

/* Both ends of the chord, for what lies beyond the first hit. SURE_HIT when the closed chord and
 * [t_min, t_max] have a point in common (the ray may then lie wholly inside, where sure_plane_hit_*
 * says miss); otherwise as above. */
sure_status sure_plane_interval_float32(const sure_ray *ray, const sure_plane *plane,
                                        sure_interval *interval);
sure_status sure_plane_interval_textbook(const sure_ray *ray, const sure_plane *plane,
                                         sure_interval *interval);
sure_status sure_plane_interval_stable(const sure_ray *ray, const sure_plane *plane,
                                       sure_interval *interval);
sure_status sure_plane_interval_certain(const sure_ray *ray, const sure_plane *plane,
                                        sure_interval *interval);
sure_status sure_plane_interval_exact(const sure_ray *ray, const sure_plane *plane,
                                      sure_interval *interval);

/* Is there a hit at all? The status of sure_plane_hit_*, without its outputs. */
sure_status sure_plane_occluded_float32(const sure_ray *ray, const sure_plane *plane);
sure_status sure_plane_occluded_textbook(const sure_ray *ray, const sure_plane *plane);
sure_status sure_plane_occluded_stable(const sure_ray *ray, const sure_plane *plane);
sure_status sure_plane_occluded_certain(const sure_ray *ray, const sure_plane *plane);
sure_status sure_plane_occluded_exact(const sure_ray *ray, const sure_plane *plane);

/* N/|N| as given, whichever side the ray comes from.
 * Entry: ray and plane as given to sure_plane_hit_*, which answered SURE_HIT and *hit. */
sure_vec3 sure_plane_normal_float32(const sure_ray *ray, const sure_plane *plane,
                                    const sure_hit *hit);
sure_vec3 sure_plane_normal_textbook(const sure_ray *ray, const sure_plane *plane,
                                     const sure_hit *hit);
sure_vec3 sure_plane_normal_stable(const sure_ray *ray, const sure_plane *plane,
                                   const sure_hit *hit);
sure_vec3 sure_plane_normal_certain(const sure_ray *ray, const sure_plane *plane,
                                    const sure_hit *hit);
sure_vec3 sure_plane_normal_exact(const sure_ray *ray, const sure_plane *plane,
                                  const sure_hit *hit);

#ifdef __cplusplus
}
#endif
#endif
