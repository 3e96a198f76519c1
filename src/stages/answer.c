/* SPDX-License-Identifier: MIT */
#include <surehit/answer.h>
#include <surehit/tier.h>
#include <surehit/version.h>

#include <stddef.h>
#include <string.h>

static const char *name_of(unsigned member, const char *const names[], size_t count)
{
    return member < count ? names[member] : NULL;
}
#define NAME_OF(member, names) name_of((unsigned)(member), names, sizeof(names) / sizeof *(names))

const char *sure_status_name(sure_status status)
{
    static const char *const names[] = {"miss", "hit", "invalid"};
    return NAME_OF(status, names);
}

const char *sure_part_name(sure_part part)
{
#define NAME(part, PART) [SURE_PART_##PART] = #part,
    static const char *const names[] = {SURE_EACH_PART(NAME)};
#undef NAME
    return NAME_OF(part, names);
}

const char *sure_field_name(sure_field field)
{
#define NAME(field, FIELD) [SURE_FIELD_##FIELD] = #field,
    static const char *const names[] = {SURE_EACH_FIELD(NAME)};
#undef NAME
    return NAME_OF(field, names);
}

static const char *const tier_names[SURE_TIERS] = {"float32", "textbook", "stable", "certain",
                                                   "exact"};

const char *sure_tier_name(sure_tier tier)
{
    return NAME_OF(tier, tier_names);
}

int sure_tier_from_name(const char *name, sure_tier *tier)
{
    for (int i = 0; i < SURE_TIERS; i++) {
        if (strcmp(name, tier_names[i]) == 0) {
            *tier = (sure_tier)i;
            return 1;
        }
    }
    return 0;
}

const char *sure_stage_name(sure_stage stage)
{
    static const char *const names[] = {"double", "double-double", "mod128", "exact"};
    return NAME_OF(stage, names);
}

int sure_version(void)
{
    return SUREHIT_VERSION;
}
