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
/* The filter once more, with a discriminant from the next two stages. */
static bool OWN(_quarter_hit)(const question *asked, t_wanted wanted, sure_status *status,
                              sure_hit *hit, sure_stage *stage)
{
    const PUBLIC() *shape = &asked->object->as.SHAPE;
    filter_chord found;
    filter_end first;
    double t, error;
    filter_verdict verdict = OWN(_filter_known)(asked->ray, shape, &found, stage);
    if (verdict == FILTER_CHORD)
        verdict = filter_first(&found, asked->ray, &first);
    *status = SURE_MISS;
    if (verdict != FILTER_CHORD)
        return verdict == FILTER_MISS;
    t = first.t;
    if (wanted == T_EXACT &&
        !(environment_is_nearest() &&
          (first.end.at == POINT_TOUCH ? OWN(_touch_polish)(asked->ray, shape, &first, &t)
                                       : OWN(_polish)(asked->ray, shape, &first, &t))))
        return false;
    if (!question_unscale(asked, t, &t) || !question_unscale(asked, first.error, &error))
        return false;
    *hit = (sure_hit){t, wanted == T_EXACT ? ladder_half_ulp(t) : error, first.end.part};
    *status = SURE_HIT;
    return true;
}
#endif

/* The stages behind the filter. Not inlined, so that they cost it nothing. */
LADDER_RARE static sure_status OWN(_rest)(const sure_ray *ray, const PUBLIC() * shape,
                                          t_wanted wanted, sure_hit *hit, sure_stage *stage)
{
    sure_object object = {.shape = SHAPE_NUMBER, .as.SHAPE = *shape};
    question asked;
    *stage = SURE_STAGE_DOUBLE;
    if (PUBLIC(_check)(ray, shape) != SURE_FIELD_NONE)
        return SURE_INVALID;
    *stage = SURE_STAGE_DOUBLE_DOUBLE;
    bool in_range = question_of(ray, &object, &asked);
#ifdef SHAPE_HAS_QUARTER
    sure_status status;
    if (in_range && OWN(_quarter_hit)(&asked, wanted, &status, hit, stage))
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
    return ladder_normal(ray, &object, T_CERTAIN);
}

sure_vec3 PUBLIC(_normal_exact)(const sure_ray *ray, const PUBLIC() * shape, const sure_hit *hit)
{
    (void)hit;
    sure_object object = OWN(_object)(shape);
    return ladder_normal(ray, &object, T_EXACT);
}
