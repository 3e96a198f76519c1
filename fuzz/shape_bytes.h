/* SPDX-License-Identifier: MIT */
/* Bytes into questions about shapes. The first byte says how: raw doubles; shaped doubles; or a
 * byte program that builds what is exactly tangent, on a rim, at the apex, parallel, edge-on or on
 * the surface out of small integers, and then moves single numbers by a few doubles. */
#pragma once

#include "fuzz.h"

#include "test_shape.h"

/* False where the bytes don't suffice. */
bool fuzz_case(fuzz_bytes *bytes, sure_shape shape, sure_case *question);

/* The hit by that tier; where there is none, that of the question with valid numbers and an open
 * range, and then of a ray that is aimed at the object's first point: for those who can do nothing
 * with a miss. */
bool fuzz_hit(sure_case *question, sure_tier tier, sure_hit *hit);

/* Another object for the question's ray: any, the same, moved by ulps, mirrored, of the same
 * numbers but another shape (same centre and radius, ...), or a plane across the ray near `t`. */
bool fuzz_other_object(fuzz_bytes *bytes, const sure_case *question, double t, sure_object *other);

/* A plane through the double nearest to the ray's point at `t`, across the ray. */
sure_object fuzz_plane_across(const sure_ray *ray, double t);

/* Which of the dear checks are made is drawn from all bytes together. A byte of their own would
 * soon ask for the dearest always, since these run through most code. */
uint64_t fuzz_draws(const uint8_t *data, size_t size);

/* One in `of`; consumes what it is drawn from. */
bool fuzz_drawn(uint64_t *draws, uint64_t of);

/* 1, and the more the more the numbers differ in size: how much longer exact arithmetic on them
 * takes, more or less. */
uint64_t fuzz_cost(const sure_case *question);

/* The more the numbers differ in size, the more often with smaller exponents. */
void fuzz_cheapen(sure_case *question, uint64_t *draws);
