/* The flat disc: the points of a plane within a radius of its centre, rim included. */
#ifndef SUREHIT_DISC_H
#define SUREHIT_DISC_H

#include <surehit/answer.h>
#include <surehit/ray.h>
#include <surehit/shape.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    sure_vec3 centre; /* Q: finite */
    sure_vec3 normal; /* N: finite, not zero, of any length */
    double radius;    /* r: finite, >= 0; 0 makes the disc a point */
} sure_disc;

/* The first invalid field of ray or disc, in the contract's order, or SURE_FIELD_NONE. */
sure_field sure_disc_check(const sure_ray *ray, const sure_disc *disc);

/* First boundary point of the disc on the ray (the set itself; a ray inside its plane hits at the
 * first point of its chord).
 *
 * Entry    any values; what the contract calls invalid is answered SURE_INVALID.
 * Returns  SURE_HIT and *hit; SURE_MISS or SURE_INVALID and *hit untouched.
 * Bound    float32, textbook: status and t as their precision has them, t_error = +infinity.
 *          stable: where the first stage of certain is certain its answer, else a guess with
 *          t_error = +infinity. certain, exact: the status, the part and the end of the chord are
 *          right, always; certain: |t - t*| <= t_error, at most SURE_T_ERROR_CAP where a double can
 *          be; exact: t correctly rounded, in any rounding mode, t_error half an ulp.
 * Source   notes, "top circle of the cylinder".
 * Proof    docs/derivations/disc.md, docs/proofs/stages.md; what the notes print wrong,
 *          docs/errata.md.
 * Laws     1 to 9 of <surehit/shape.h>. */
sure_status sure_disc_hit_float32(const sure_ray *ray, const sure_disc *disc, sure_hit *hit);
sure_status sure_disc_hit_textbook(const sure_ray *ray, const sure_disc *disc, sure_hit *hit);
sure_status sure_disc_hit_stable(const sure_ray *ray, const sure_disc *disc, sure_hit *hit);
sure_status sure_disc_hit_certain(const sure_ray *ray, const sure_disc *disc, sure_hit *hit);
sure_status sure_disc_hit_exact(const sure_ray *ray, const sure_disc *disc, sure_hit *hit);

/* Both ends of the chord, for what lies beyond the first hit. SURE_HIT when the closed chord and
 * [t_min, t_max] have a point in common (the ray may then lie wholly inside, where sure_disc_hit_*
 * says miss); otherwise as above. */
sure_status sure_disc_interval_float32(const sure_ray *ray, const sure_disc *disc,
                                       sure_interval *interval);
sure_status sure_disc_interval_textbook(const sure_ray *ray, const sure_disc *disc,
                                        sure_interval *interval);
sure_status sure_disc_interval_stable(const sure_ray *ray, const sure_disc *disc,
                                      sure_interval *interval);
sure_status sure_disc_interval_certain(const sure_ray *ray, const sure_disc *disc,
                                       sure_interval *interval);
sure_status sure_disc_interval_exact(const sure_ray *ray, const sure_disc *disc,
                                     sure_interval *interval);

/* Is there a hit at all? The status of sure_disc_hit_*, without its outputs. */
sure_status sure_disc_occluded_float32(const sure_ray *ray, const sure_disc *disc);
sure_status sure_disc_occluded_textbook(const sure_ray *ray, const sure_disc *disc);
sure_status sure_disc_occluded_stable(const sure_ray *ray, const sure_disc *disc);
sure_status sure_disc_occluded_certain(const sure_ray *ray, const sure_disc *disc);
sure_status sure_disc_occluded_exact(const sure_ray *ray, const sure_disc *disc);

/* N/|N| as given, whichever side the ray comes from.
 * Entry: ray and disc as given to sure_disc_hit_*, which answered SURE_HIT and *hit. */
sure_vec3 sure_disc_normal_float32(const sure_ray *ray, const sure_disc *disc, const sure_hit *hit);
sure_vec3 sure_disc_normal_textbook(const sure_ray *ray, const sure_disc *disc,
                                    const sure_hit *hit);
sure_vec3 sure_disc_normal_stable(const sure_ray *ray, const sure_disc *disc, const sure_hit *hit);
sure_vec3 sure_disc_normal_certain(const sure_ray *ray, const sure_disc *disc, const sure_hit *hit);
sure_vec3 sure_disc_normal_exact(const sure_ray *ray, const sure_disc *disc, const sure_hit *hit);

#ifdef __cplusplus
}
#endif
#endif
