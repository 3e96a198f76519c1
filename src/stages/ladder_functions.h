/* One shape's public functions of the tiers certain and exact: the lists of stages. Included with
 * SHAPE and SHAPE_NUMBER defined, after <shape>_filter, <shape>_polish and <shape>_quick_normal. */
#define JOIN3(a, b, c) a##b##c
#define JOIN(a, b, c) JOIN3(a, b, c)
#define PUBLIC(question) JOIN(sure_, SHAPE, question)
#define OWN(function) JOIN(, SHAPE, function)

static sure_object OWN(_object)(const PUBLIC() * shape)
{
    return (sure_object){.shape = SHAPE_NUMBER, .as.SHAPE = *shape};
}

static inline filter_verdict OWN(_first)(const sure_ray *ray, const PUBLIC() * shape,
                                         filter_end *first)
{
    filter_chord found;
    filter_verdict verdict = OWN(_filter)(ray, shape, &found);
    return verdict == FILTER_CHORD ? filter_first(&found, ray, first) : verdict;
}

#ifdef SHAPE_HAS_QUARTER
/* A certain end as one of the asked ray, and rounded correctly if wanted; false where that can't be
 * told. */
static bool OWN(_end)(const question *asked, const PUBLIC() * shape, t_wanted wanted,
                      filter_end *end)
{
    double t = end->t;
    if (filter_at_start(end))
        return true;
    if (wanted == T_EXACT &&
        !(environment_is_nearest() &&
          (end->end.at == POINT_TOUCH ? OWN(_touch_polish)(asked->ray, shape, end, &t)
                                      : OWN(_polish)(asked->ray, shape, end, &t))))
        return false;
    return question_unscale(asked, t, &end->t) && question_unscale(asked, end->error, &end->error);
}

/* What the filter found for a question, as an answer; false when it is none. */
static bool OWN(_answer)(const question *asked, const PUBLIC() * shape, filter_verdict verdict,
                         const filter_chord *found, t_wanted wanted, sure_status *status,
                         sure_hit *hit)
{
    filter_end first = {0};
    if (verdict == FILTER_CHORD)
        verdict = filter_first_known(found, asked->ray, &first);
    *status = SURE_MISS;
    if (verdict != FILTER_CHORD)
        return verdict == FILTER_MISS;
    *status = SURE_HIT;
    if (!OWN(_end)(asked, shape, wanted, &first))
        return false;
    bool rounded = wanted == T_EXACT && first.end.at != POINT_START;
    double error = rounded ? ladder_half_ulp(first.t) : first.error;
    *hit = (sure_hit){first.t, error, first.end.part};
    return true;
}

/* With more digits for what the filter is uncertain of. */
static bool OWN(_with_known)(const question *asked, const PUBLIC() * shape,
                             const OWN(_terms) * terms, t_wanted wanted, sure_status *status,
                             sure_hit *hit, sure_stage *stage)
{
    filter_chord found;
    *stage = SURE_STAGE_DOUBLE_DOUBLE;
    filter_verdict verdict = OWN(_filter_known)(asked->ray, shape, terms, &found, stage);
    return OWN(_answer)(asked, shape, verdict, &found, wanted, status, hit);
}

/* Of the terms only what this needs is computed, so it is asked before they are. */
static inline bool OWN(_in_range)(const sure_ray *ray, const PUBLIC() * shape)
{
    const OWN(_terms) terms = OWN(_terms_of)(ray, shape);
    return OWN(_fits)(shape, &terms);
}

/* A scaled question, from the filter on. */
static bool OWN(_again)(const question *asked, t_wanted wanted, sure_status *status, sure_hit *hit,
                        sure_stage *stage)
{
    const PUBLIC() *shape = &asked->object->as.SHAPE;
    const OWN(_terms) terms = OWN(_terms_of)(asked->ray, shape);
    filter_chord found;
    filter_verdict verdict = OWN(_filter_of)(asked->ray, shape, &terms, &found);
    if (verdict == FILTER_MISS || wanted == T_CERTAIN)
        *stage = SURE_STAGE_DOUBLE;
    return OWN(_answer)(asked, shape, verdict, &found, wanted, status, hit) ||
           (OWN(_fits)(shape, &terms) &&
            OWN(_with_known)(asked, shape, &terms, wanted, status, hit, stage));
}
#endif

#ifdef SHAPE_HAS_CLOSE
/* A second stage of the shape's own, which takes any input; *hit is set when it is one. */
static inline filter_verdict OWN(_closely)(const sure_ray *ray, const PUBLIC() * shape,
                                           t_wanted wanted, sure_hit *hit)
{
    sure_hit found;
    filter_verdict verdict = FILTER_UNCERTAIN;
    if (environment_is_nearest())
        verdict = OWN(_close)(ray, shape, wanted, &found);
    if (verdict == FILTER_CHORD)
        *hit = found;
    return verdict;
}
#endif

/* The stages behind the filter. Not inlined, so that they cost it nothing. */
LADDER_RARE static sure_status OWN(_rest)(const sure_ray *ray, const PUBLIC() * shape,
                                          t_wanted wanted, sure_hit *hit, sure_stage *stage)
{
    question asked;
    *stage = SURE_STAGE_DOUBLE_DOUBLE;
#ifdef SHAPE_HAS_CLOSE
    filter_verdict closely = OWN(_closely)(ray, shape, wanted, hit);
    if (closely != FILTER_UNCERTAIN)
        return closely == FILTER_CHORD ? SURE_HIT : SURE_MISS;
#endif
#ifdef SHAPE_HAS_QUARTER
    sure_status status;
    asked.ray = ray;
    asked.t_exponent = 0;
    bool fits = OWN(_in_range)(ray, shape);
    if (fits) {
        const OWN(_terms) terms = OWN(_terms_of)(ray, shape);
        if (OWN(_with_known)(&asked, shape, &terms, wanted, &status, hit, stage))
            return status;
    }
#endif
    if (PUBLIC(_check)(ray, shape) != SURE_FIELD_NONE) {
        *stage = SURE_STAGE_DOUBLE;
        return SURE_INVALID;
    }
    sure_object object = OWN(_object)(shape);
    bool in_range = question_of(ray, &object, &asked);
#ifdef SHAPE_HAS_QUARTER
    if (!fits && in_range && OWN(_again)(&asked, wanted, &status, hit, stage))
        return status;
#endif
    return ladder_hit(ray, &object, in_range ? &asked : NULL, wanted, hit, stage);
}

sure_status PUBLIC(_hit_certain)(const sure_ray *ray, const PUBLIC() * shape, sure_hit *hit)
{
    filter_end first;
    filter_verdict verdict = OWN(_first)(ray, shape, &first);
    if (verdict == FILTER_MISS)
        return SURE_MISS;
    if (verdict == FILTER_CHORD) {
        *hit = (sure_hit){first.t, first.error, first.end.part};
        return SURE_HIT;
    }
    sure_stage unused;
    return OWN(_rest)(ray, shape, T_CERTAIN, hit, &unused);
}

sure_status PUBLIC(_hit_exact)(const sure_ray *ray, const PUBLIC() * shape, sure_hit *hit)
{
    filter_end first;
    double t;
    filter_verdict verdict = OWN(_first)(ray, shape, &first);
    if (verdict == FILTER_MISS)
        return SURE_MISS;
    if (verdict == FILTER_CHORD && environment_is_nearest() &&
        OWN(_polish)(ray, shape, &first, &t)) {
        *hit = (sure_hit){t, ladder_half_ulp(t), first.end.part};
        return SURE_HIT;
    }
    sure_stage unused;
    return OWN(_rest)(ray, shape, T_EXACT, hit, &unused);
}

sure_stage JOIN(ladder_, SHAPE, _stage)(const sure_ray *ray, const PUBLIC() * shape,
                                        t_wanted wanted)
{
    filter_end first;
    double t;
    filter_verdict verdict = OWN(_first)(ray, shape, &first);
    if (verdict == FILTER_MISS || (verdict == FILTER_CHORD && wanted == T_CERTAIN))
        return SURE_STAGE_DOUBLE;
    if (verdict == FILTER_CHORD && environment_is_nearest() && OWN(_polish)(ray, shape, &first, &t))
        return SURE_STAGE_DOUBLE_DOUBLE;
    sure_hit hit;
    sure_stage stage;
    (void)OWN(_rest)(ray, shape, wanted, &hit, &stage);
    return stage;
}

/* Both ends and whether the chord and [t_min, t_max] have a point in common. */
static inline filter_verdict OWN(_chord_in_range)(const sure_ray *ray, const PUBLIC() * shape,
                                                  filter_chord *found)
{
    filter_verdict verdict = OWN(_filter)(ray, shape, found);
    return verdict == FILTER_CHORD ? filter_meets(found, ray) : verdict;
}

sure_status PUBLIC(_interval_certain)(const sure_ray *ray, const PUBLIC() * shape,
                                      sure_interval *interval)
{
    filter_chord found;
    filter_verdict verdict = OWN(_chord_in_range)(ray, shape, &found);
    if (verdict == FILTER_MISS)
        return SURE_MISS;
    if (verdict == FILTER_CHORD) {
        *interval = (sure_interval){found.enter.t, found.leave.t, found.enter.end.part,
                                    found.leave.end.part};
        ladder_order_ends(interval);
        return SURE_HIT;
    }
    sure_object object = OWN(_object)(shape);
    return ladder_interval(ray, &object, T_CERTAIN, interval);
}

sure_status PUBLIC(_interval_exact)(const sure_ray *ray, const PUBLIC() * shape,
                                    sure_interval *interval)
{
    filter_chord found;
    double enter, leave;
    filter_verdict verdict = OWN(_chord_in_range)(ray, shape, &found);
    if (verdict == FILTER_MISS)
        return SURE_MISS;
    if (verdict == FILTER_CHORD && environment_is_nearest() &&
        OWN(_polish)(ray, shape, &found.enter, &enter) &&
        OWN(_polish)(ray, shape, &found.leave, &leave)) {
        *interval = (sure_interval){enter, leave, found.enter.end.part, found.leave.end.part};
        return SURE_HIT;
    }
    sure_object object = OWN(_object)(shape);
    return ladder_interval(ray, &object, T_EXACT, interval);
}

sure_status PUBLIC(_occluded_certain)(const sure_ray *ray, const PUBLIC() * shape)
{
    sure_hit unused;
    return PUBLIC(_hit_certain)(ray, shape, &unused);
}

sure_status PUBLIC(_occluded_exact)(const sure_ray *ray, const PUBLIC() * shape)
{
    return PUBLIC(_occluded_certain)(ray, shape);
}

sure_vec3 PUBLIC(_normal_certain)(const sure_ray *ray, const PUBLIC() * shape, const sure_hit *hit)
{
    sure_vec3 normal;
    if (OWN(_quick_normal)(ray, shape, hit, &normal))
        return normal;
    sure_object object = OWN(_object)(shape);
    return ladder_normal(ray, &object, hit->part, T_CERTAIN);
}

sure_vec3 PUBLIC(_normal_exact)(const sure_ray *ray, const PUBLIC() * shape, const sure_hit *hit)
{
    sure_object object = OWN(_object)(shape);
    return ladder_normal(ray, &object, hit->part, T_EXACT);
}
