#define _POSIX_C_SOURCE 200809L /* open_memstream */

#include "regress.h"

#include <errno.h>
#include <stdlib.h>
#include <unistd.h>

static regress_verdict find(const char *scene, const char *golden, const render_settings *settings,
                            FILE *messages, regression *found)
{
    if (scene && !render_file(scene, settings, messages, &found->got))
        return REGRESS_BAD_SCENE;
    if (scene && access(golden, F_OK) != 0 && errno == ENOENT)
        return REGRESS_NEW;
    if (!picture_read(golden, messages, &found->golden))
        return scene ? REGRESS_BAD_GOLDEN : REGRESS_STALE;
    if (!scene)
        return REGRESS_STALE;
    found->apart = difference_of(&found->golden, &found->got);
    return difference_is_none(&found->apart) ? REGRESS_SAME : REGRESS_DIFFERS;
}

bool regress(const char *scene, const char *golden, const render_settings *settings,
             regression *found)
{
    size_t size;
    *found = (regression){.verdict = REGRESS_VERDICTS};
    FILE *messages = open_memstream(&found->messages, &size);
    if (!messages)
        return false;
    found->verdict = find(scene, golden, settings, messages, found);
    if (fclose(messages) == 0 && found->messages)
        return true;
    regress_free(found);
    return false;
}

void regress_free(regression *found)
{
    picture_free(&found->golden);
    picture_free(&found->got);
    free(found->messages);
    found->messages = NULL;
}

/* Of a scene, and of so many. */
static const struct {
    const char *one, *many;
} words[REGRESS_VERDICTS] = {
    [REGRESS_SAME] = {"same", "same"},
    [REGRESS_DIFFERS] = {"differs: ", "different"},
    [REGRESS_NEW] = {"new: no golden picture yet", "new"},
    [REGRESS_STALE] = {"stale: a golden picture without a scene", "stale golden picture"},
    [REGRESS_BAD_SCENE] = {"error: the scene can't be drawn", "not drawn"},
    [REGRESS_BAD_GOLDEN] = {"error: the golden picture can't be read",
                            "with an unreadable golden picture"},
};

void regress_print_verdict(FILE *out, const regression *found)
{
    fputs(words[found->verdict].one, out);
    if (found->verdict == REGRESS_DIFFERS)
        difference_print(out, &found->apart);
}

void regress_print_counts(FILE *out, const int counts[REGRESS_VERDICTS])
{
    int scenes = 0, stale = counts[REGRESS_STALE];
    for (int i = 0; i < REGRESS_VERDICTS; i++)
        scenes += i == REGRESS_STALE ? 0 : counts[i];
    fprintf(out, "%d scene%s", scenes, scenes == 1 ? "" : "s");
    const char *between = ": ";
    for (int i = 0; i < REGRESS_VERDICTS; i++) {
        if (i == REGRESS_STALE || counts[i] == 0)
            continue;
        fprintf(out, "%s%d %s", between, counts[i], words[i].many);
        between = ", ";
    }
    if (stale > 0)
        fprintf(out, "; %d %s%s", stale, words[REGRESS_STALE].many, stale == 1 ? "" : "s");
}
