/* The solid box, its faces across the axes. */
#ifndef SUREHIT_BOX_H
#define SUREHIT_BOX_H

#include <surehit/answer.h>
#include <surehit/ray.h>
#include <surehit/shape.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    sure_vec3 low;  /* the corner of the least coordinates: finite */
    sure_vec3 high; /* that of the greatest: finite, none below low's; an equal one makes it flat */
} sure_box;

/* The first invalid field of ray or box, in the contract's order, or SURE_FIELD_NONE. */
sure_field sure_box_check(const sure_ray *ray, const sure_box *box);

/* First boundary point of the box on the ray (from inside, the far side; an edge that is
 * touched is a hit).
 *
 * Entry    any values; what the contract calls invalid is answered SURE_INVALID.
 * Returns  SURE_HIT and *hit; SURE_MISS or SURE_INVALID and *hit untouched.
 * Bound    float32, textbook: status and t as their precision has them, t_error = +infinity.
 *          stable: where the first stage of certain is certain its answer, else a guess with
 *          t_error = +infinity. certain, exact: the status, the part and the end of the chord are
 *          right, always; certain: |t - t*| <= t_error, at most SURE_T_ERROR_CAP where a double can
 *          be; exact: t correctly rounded, in any rounding mode, t_error half an ulp.
 * Source   the intersection of slabs (Kay and Kajiya 1986); the notes have no box.
 * Proof    docs/proofs/box.md, docs/proofs/stages.md.
 * Laws     1 to 9 of <surehit/shape.h>. */
sure_status sure_box_hit_float32(const sure_ray *ray, const sure_box *box, sure_hit *hit);
sure_status sure_box_hit_textbook(const sure_ray *ray, const sure_box *box, sure_hit *hit);
sure_status sure_box_hit_stable(const sure_ray *ray, const sure_box *box, sure_hit *hit);
sure_status sure_box_hit_certain(const sure_ray *ray, const sure_box *box, sure_hit *hit);
sure_status sure_box_hit_exact(const sure_ray *ray, const sure_box *box, sure_hit *hit);

/* Both ends of the chord, for what lies beyond the first hit. SURE_HIT when the closed chord and
 * [t_min, t_max] have a point in common (the ray may then lie wholly inside, where
 * sure_box_hit_* says miss); otherwise as above. */
sure_status sure_box_interval_float32(const sure_ray *ray, const sure_box *box,
                                      sure_interval *interval);
sure_status sure_box_interval_textbook(const sure_ray *ray, const sure_box *box,
                                       sure_interval *interval);
sure_status sure_box_interval_stable(const sure_ray *ray, const sure_box *box,
                                     sure_interval *interval);
sure_status sure_box_interval_certain(const sure_ray *ray, const sure_box *box,
                                      sure_interval *interval);
sure_status sure_box_interval_exact(const sure_ray *ray, const sure_box *box,
                                    sure_interval *interval);

/* Is there a hit at all? The status of sure_box_hit_*, without its outputs. */
sure_status sure_box_occluded_float32(const sure_ray *ray, const sure_box *box);
sure_status sure_box_occluded_textbook(const sure_ray *ray, const sure_box *box);
sure_status sure_box_occluded_stable(const sure_ray *ray, const sure_box *box);
sure_status sure_box_occluded_certain(const sure_ray *ray, const sure_box *box);
sure_status sure_box_occluded_exact(const sure_ray *ray, const sure_box *box);

/* The outward unit normal of the face that is hit.
 * Entry: ray and box as given to sure_box_hit_*, which answered SURE_HIT and *hit. */
sure_vec3 sure_box_normal_float32(const sure_ray *ray, const sure_box *box, const sure_hit *hit);
sure_vec3 sure_box_normal_textbook(const sure_ray *ray, const sure_box *box, const sure_hit *hit);
sure_vec3 sure_box_normal_stable(const sure_ray *ray, const sure_box *box, const sure_hit *hit);
sure_vec3 sure_box_normal_certain(const sure_ray *ray, const sure_box *box, const sure_hit *hit);
sure_vec3 sure_box_normal_exact(const sure_ray *ray, const sure_box *box, const sure_hit *hit);

#ifdef __cplusplus
}
#endif
#endif
