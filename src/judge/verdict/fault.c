#include "fault.h"

#include <math.h>

const char *fault_name(fault which)
{
#define FAULT(NAME, name) name,
    static const char *const names[FAULTS] = {EACH_FAULT(FAULT)};
    return names[which];
}

bool fault_is_hit(const case_answer *truth, const reply *given)
{
    return truth->status == SURE_HIT && given->kind == REPLY_ANSWERED && given->status == SURE_HIT;
}

static unsigned faults_of_decision(const case_answer *truth, const reply *given)
{
    if (truth->status == SURE_INVALID) {
        if (given->status != SURE_INVALID)
            return FAULT_BIT(FAULT_INVALID_ACCEPTED);
        bool other = given->field != SURE_FIELD_NONE && given->field != truth->field;
        return other ? FAULT_BIT(FAULT_WRONG_FIELD) : 0;
    }
    if (given->status == SURE_INVALID)
        return FAULT_BIT(FAULT_REFUSED);
    if (given->status != truth->status)
        return FAULT_BIT(given->status == SURE_HIT ? FAULT_FALSE_HIT : FAULT_FALSE_MISS);
    bool other = given->status == SURE_HIT && given->part != REPLY_NO_PART &&
                 given->part != (int)truth->part;
    return other ? FAULT_BIT(FAULT_WRONG_PART) : 0;
}

static unsigned faults_of_outputs(const sure_case *question, const reply *given)
{
    unsigned found = 0;
    if (given->status != SURE_HIT)
        return given->touched ? FAULT_BIT(FAULT_TOUCHED) : 0;
    const sure_vec3 *n = &given->normal;
    if (isnan(given->t) || (given->has_normal && (isnan(n->x) || isnan(n->y) || isnan(n->z))))
        found |= FAULT_BIT(FAULT_NOT_A_NUMBER);
    if (given->t < question->ray.t_min || given->t > question->ray.t_max)
        found |= FAULT_BIT(FAULT_OUT_OF_RANGE);
    return found;
}

unsigned faults_of(const sure_case *question, const case_answer *truth, const reply *given)
{
    unsigned found = given->leaked ? FAULT_BIT(FAULT_LEAKED) : 0;
    if (given->kind == REPLY_UNASKED)
        return found;
    if (given->kind != REPLY_ANSWERED)
        return found | FAULT_BIT(FAULT_GARBAGE + (given->kind - REPLY_GARBAGE));
    if (given->changed)
        found |= FAULT_BIT(FAULT_CHANGED);
    return found | faults_of_decision(truth, given) | faults_of_outputs(question, given);
}
