/* SPDX-License-Identifier: MIT */
/* Everything that the tiers certain and exact promise of one case, against who knows the truth. */
#pragma once

#include "campaign_tally.h"

/* Told of each broken promise. */
typedef void campaign_report(const sure_case *question, const char *what);

/* What is checked of a case besides the status, part, field, t and t_error. */
typedef struct {
    bool normal, interval, occluded, spawn; /* normal and spawn: of a hit */
    bool bracket, block;
    uint64_t parts; /* a draw for the points near a solid's ends; 0: none */
} campaign_more;

/* What is checked of the case with that number. */
campaign_more campaign_more_of(uint64_t index);

#define CAMPAIGN_PARTS 5

/* Who knows. Answers are those of reference.h; NULL: that is not known, and not checked. */
typedef struct {
    const char *name;
    sure_tier first; /* the tiers from here on are asked */
    bool floats;     /* certain_f and exact_f of the case as floats have it, and nothing else */
    sure_field (*check)(const sure_ray *ray, const sure_object *object);
    sure_status (*hit)(const sure_ray *ray, const sure_object *object, double *t, sure_part *part,
                       sure_vec3 *normal);
    sure_status (*interval)(const sure_ray *ray, const sure_object *object,
                            sure_interval *interval);
    /* Where the rounded t and normal don't tell: is it within the error, or may it be? */
    bool (*hit_within)(const sure_ray *ray, const sure_object *object, double t, double error);
    bool (*normal_within)(const sure_ray *ray, const sure_object *object, sure_vec3 normal,
                          double error);
    int (*where)(const sure_object *object, sure_vec3 point);
    /* Which promises are broken, NULL for one that holds: the notes' parts of a valid solid, and
     * the hit by a sign change along the ray. */
    void (*parts)(const sure_case *question, uint64_t draw, const char *broken[CAMPAIGN_PARTS]);
    const char *(*bracket)(const sure_case *question);
} campaign_truth;

/* The reference: everything. */
extern const campaign_truth truth_by_reference;

/* The last stage alone, exact integers, twice as quick: certain and exact are held against it. */
extern const campaign_truth truth_by_exact;

/* The same in floats: certain_f, exact_f and blocks of certain_f are held against it. */
extern const campaign_truth truth_of_floats;

/* Counts the case in *sum. */
void campaign_check(const campaign_truth *by, const sure_case *question, campaign_more more,
                    campaign_report *report, pair_tally *sum);
