#include "campaign_tally.h"

#include "reference.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

enum {
    TIER_COUNTS = sizeof(tier_tally) / sizeof(uint64_t),
    PAIR_COUNTS = sizeof(pair_tally) / sizeof(uint64_t),
    OWN_COUNTS = PAIR_COUNTS - SURE_TIERS * TIER_COUNTS,
    LINE_MAX_LENGTH = 4096
};

static const char *const own_names[OWN_COUNTS] = {"cases",     "hits",       "misses", "invalid",
                                                  "normals",   "intervals",  "spawns", "no_outside",
                                                  "no_inside", "out_of_cap", "broken"};
static const char *const tier_names[TIER_COUNTS] = {
    "false_hits", "false_misses",  "wrong_parts", "wrong_validity", "ulps_0",
    "ulps_1",     "ulps_4",        "ulps_64",     "ulps_65536",     "ulps_more",
    "double",     "double_double", "mod128",      "exact"};

static const uint64_t bins[TALLY_BINS] = {0, 1, 4, 64, 65536, UINT64_MAX};

bool tally_hit(tier_tally *sum, sure_tier tier, const tally_truth *truth, sure_status status,
               const sure_hit *hit)
{
    if ((status == SURE_INVALID) != (truth->status == SURE_INVALID))
        sum->wrong_validity++;
    else if (status != truth->status)
        status == SURE_HIT ? sum->false_hits++ : sum->false_misses++;
    else if (status == SURE_HIT && hit->part != truth->part)
        sum->wrong_parts++;
    else {
        if (status == SURE_HIT) {
            uint64_t away =
                reference_ulps(hit->t, truth->t) >> (tier == SURE_TIER_FLOAT32 ? 29 : 0);
            int bin = 0;
            while (away > bins[bin])
                bin++;
            sum->ulps[bin]++;
        }
        return true;
    }
    return false;
}

void tally_truth_seen(pair_tally *sum, sure_status status)
{
    sum->cases++;
    sum->hits += status == SURE_HIT;
    sum->misses += status == SURE_MISS;
    sum->invalid += status == SURE_INVALID;
}

void tally_add(pair_tally *total, const pair_tally *sum)
{
    uint64_t to[PAIR_COUNTS], from[PAIR_COUNTS];
    memcpy(to, total, sizeof to);
    memcpy(from, sum, sizeof from);
    for (int i = 0; i < PAIR_COUNTS; i++)
        to[i] += from[i];
    memcpy(total, to, sizeof to);
}

static void write_head(FILE *file, uint64_t seed)
{
    fprintf(file, "seed,%" PRIu64 "\nshape,regime", seed);
    for (int i = 0; i < OWN_COUNTS; i++)
        fprintf(file, ",%s", own_names[i]);
    for (sure_tier tier = 0; tier < SURE_TIERS; tier++) {
        for (int i = 0; i < TIER_COUNTS; i++)
            fprintf(file, ",%s_%s", sure_tier_name(tier), tier_names[i]);
    }
    fprintf(file, "\n");
}

static void write_row(FILE *file, sure_shape shape, regime which, const pair_tally *sum)
{
    uint64_t counts[PAIR_COUNTS];
    memcpy(counts, sum, sizeof counts);
    fprintf(file, "%s,%s", sure_shape_name(shape), regime_name(which));
    for (int i = 0; i < PAIR_COUNTS; i++)
        fprintf(file, ",%" PRIu64, counts[i]);
    fprintf(file, "\n");
}

bool tally_write(const char *path, const tally_record *record)
{
    char beside[LINE_MAX_LENGTH];
    if (snprintf(beside, sizeof beside, "%s.new", path) >= (int)sizeof beside)
        return false;
    FILE *file = fopen(beside, "w");
    if (!file)
        return false;
    write_head(file, record->seed);
    for (sure_shape shape = 0; shape < SURE_SHAPES; shape++) {
        for (regime r = 0; r < REGIMES; r++) {
            if (regime_applies(shape, r))
                write_row(file, shape, r, &record->pairs[shape][r]);
        }
    }
    bool written = !ferror(file);
    return fclose(file) == 0 && written && rename(beside, path) == 0;
}

static bool read_row(char *line, tally_record *record)
{
    char *comma = strchr(line, ','), *rest = comma ? strchr(comma + 1, ',') : NULL;
    sure_shape shape;
    regime which;
    uint64_t counts[PAIR_COUNTS];
    if (!rest)
        return false;
    *comma = *rest = '\0';
    if (!sure_shape_from_name(line, &shape) || !regime_from_name(comma + 1, &which))
        return false;
    char *at = rest;
    for (int i = 0; i < PAIR_COUNTS; i++) {
        char *end;
        if (i > 0 && *at != ',')
            return false;
        counts[i] = strtoull(at + 1, &end, 10);
        if (end == at + 1)
            return false;
        at = end;
    }
    memcpy(&record->pairs[shape][which], counts, sizeof counts);
    return *at == '\n';
}

bool tally_read(const char *path, tally_record *record)
{
    FILE *file = fopen(path, "r");
    char line[LINE_MAX_LENGTH];
    if (!file)
        return errno == ENOENT;
    bool good = fgets(line, sizeof line, file) && sscanf(line, "seed,%" SCNu64, &record->seed) == 1;
    good = good && fgets(line, sizeof line, file) && strncmp(line, "shape,regime", 12) == 0;
    while (good && fgets(line, sizeof line, file))
        good = read_row(line, record);
    fclose(file);
    return good;
}
