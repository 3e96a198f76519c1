/* SPDX-License-Identifier: MIT */
#include "regress.h"

#include "../scene/rt_notes.h"
#include "../support/complain.h"
#include "../support/folder.h"
#include "../support/printable.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define SCENE ".rt"
#define PICTURE ".png"

/* Of a scene, and of so many. */
static const struct {
    const char *one, *many;
} words[REGRESS_VERDICTS] = {
    [REGRESS_SAME] = {"same", "same"},
    [REGRESS_DIFFERS] = {"differs: ", "different"},
    [REGRESS_NEW] = {"new: no golden picture yet", "new"},
    [REGRESS_BAD_SCENE] = {"error: the scene can't be drawn", "not drawn"},
    [REGRESS_BAD_GOLDEN] = {"error: the golden picture can't be read",
                            "with an unreadable golden picture"},
    [REGRESS_STALE] = {"stale: a golden picture without a scene", "stale golden picture"},
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
    for (int i = 0; i < REGRESS_STALE; i++)
        scenes += counts[i];
    fprintf(out, "%d scene%s", scenes, scenes == 1 ? "" : "s");
    const char *between = ": ";
    for (int i = 0; i < REGRESS_STALE; i++) {
        if (counts[i] == 0)
            continue;
        fprintf(out, "%s%d %s", between, counts[i], words[i].many);
        between = ", ";
    }
    if (stale > 0)
        fprintf(out, "; %d %s%s", stale, words[REGRESS_STALE].many, stale == 1 ? "" : "s");
}

/* Reads `golden`, which need not be there, and draws `scene`; a stale picture has none (NULL). */
static regress_verdict find(const char *scene, const char *golden, const render_settings *settings,
                            FILE *messages, regression *found)
{
    if (scene &&
        (!folder_entry_ok(scene, messages) || !render_file(scene, settings, messages, &found->got)))
        return REGRESS_BAD_SCENE;
    if (scene && access(golden, F_OK) != 0 && errno == ENOENT)
        return REGRESS_NEW;
    if (!folder_entry_ok(golden, messages) || !picture_read(golden, messages, &found->golden))
        return scene ? REGRESS_BAD_GOLDEN : REGRESS_STALE;
    if (!scene)
        return REGRESS_STALE;
    found->apart = difference_of(&found->golden, &found->got);
    return difference_is_none(&found->apart) ? REGRESS_SAME : REGRESS_DIFFERS;
}

static bool has_scene(const folder_listing *scenes, const char *picture_name)
{
    size_t stem = strlen(picture_name) - strlen(PICTURE);
    for (int i = 0; i < scenes->count; i++) {
        const char *name = scenes->names[i];
        if (strlen(name) == stem + strlen(SCENE) && strncmp(name, picture_name, stem) == 0)
            return true;
    }
    return false;
}

/* A run over the folder. */

typedef struct {
    const regress_plan *plan;
    const char *golden; /* the folder */
    const folder_listing *scenes;
    regress_page page;
    int counts[REGRESS_VERDICTS];
    bool trouble; /* something could not be read or written */
    bool left;    /* something differs, is new or stale, and was not accepted */
} run;

static void no_memory(run *r)
{
    fputs("surehit regress: error: no memory\n", stderr);
    r->trouble = true;
}

/* What a scene was renamed from goes only when all that there is now has been written. */
static const char *accept_stale(run *r, const char *golden, const regression *found)
{
    if (r->trouble)
        return "kept, since not all went well";
    if (!found->golden.golden) {
        r->left = true;
        r->trouble |= !found->golden.rgb;
        return "kept, since --accept has not made it: remove it yourself";
    }
    if (unlink(golden) == 0 || complain(stderr, golden, "cannot be removed: %s", strerror(errno)))
        return "removed";
    r->trouble = true;
    return "not removed";
}

/* Is the file, by a link maybe, one of these? */
static bool is_among(const char *path, const char *folder, const folder_listing *files)
{
    bool found = false;
    for (int i = 0; !found && i < files->count; i++) {
        char *file = folder_path(folder, files->names[i], strlen(files->names[i]), "");
        found = file && folder_is_same_file(path, file);
        free(file);
    }
    return found;
}

/* Would it be written over a scene? */
static bool is_scene(const run *r, const char *path)
{
    return is_among(path, r->plan->folder, r->scenes);
}

static const char *accept_picture(run *r, const char *golden, const regression *found)
{
    picture accepted = found->got;
    accepted.golden = true;
    if (is_scene(r, golden)) {
        r->trouble = true;
        complain(stderr, golden, "a golden picture may not take the place of a scene");
        return "not accepted";
    }
    if (!folder_entry_ok(golden, NULL)) { /* which was said */
        r->trouble = true;
        return "not accepted";
    }
    bool made = mkdir(r->golden, 0777) == 0 || errno == EEXIST ||
                complain(stderr, r->golden, "cannot be made: %s", strerror(errno));
    if (made && picture_write(&accepted, golden, stderr))
        return "accepted";
    r->trouble = true;
    return "not accepted";
}

/* What was done about it, or NULL; remembers whether anything is left. */
static const char *settle(run *r, const char *golden, const regression *found)
{
    regress_verdict verdict = found->verdict;
    if (verdict == REGRESS_SAME)
        return NULL;
    if (verdict == REGRESS_BAD_SCENE || (verdict == REGRESS_BAD_GOLDEN && !r->plan->accept)) {
        r->trouble = true;
        return NULL;
    }
    if (r->plan->accept)
        return verdict == REGRESS_STALE ? accept_stale(r, golden, found)
                                        : accept_picture(r, golden, found);
    r->trouble |= !found->golden.rgb && verdict == REGRESS_STALE;
    r->left = true;
    return NULL;
}

static void report(run *r, const char *name, const regression *found, const char *remark)
{
    r->counts[found->verdict]++;
    if (r->plan->page)
        regress_page_add(&r->page, name, found, remark);
    if (r->plan->quiet && found->verdict == REGRESS_SAME)
        return;
    printf("%s: ", name);
    regress_print_verdict(stdout, found);
    printf("%s%s\n", remark ? "; " : "", remark ? remark : "");
    fflush(stdout); /* between the lines of the readers, on another stream */
}

static void look_at(run *r, const char *name, bool is_stale)
{
    size_t stem = strlen(name) - strlen(is_stale ? PICTURE : SCENE), size;
    char *scene = folder_path(r->plan->folder, name, stem, SCENE);
    char *golden = folder_path(r->golden, name, stem, PICTURE), *shown = rt_printable_name(name);
    regression found = {.verdict = REGRESS_VERDICTS};
    FILE *messages = open_memstream(&found.messages, &size);
    if (scene && golden && shown && messages)
        found.verdict = find(is_stale ? NULL : scene, golden, &r->plan->settings, messages, &found);
    if (messages && fclose(messages) == 0 && found.verdict != REGRESS_VERDICTS) {
        fputs(found.messages, stderr);
        report(r, shown, &found, settle(r, golden, &found));
    } else {
        no_memory(r);
    }
    picture_free(&found.golden);
    picture_free(&found.got);
    free(found.messages);
    free(scene);
    free(golden);
    free(shown);
}

static void print_summary(const run *r)
{
    regress_print_counts(stdout, r->counts);
    if (r->plan->page)
        printable_printf(stdout, "; see %s", r->plan->page);
    else if (r->left)
        printf("; -o PAGE.html shows it, --accept makes it golden");
    putchar('\n');
}

/* Is the page one of the golden pictures, or where one will be? */
static bool is_golden(const run *r, const folder_listing *pictures)
{
    const char *page = r->plan->page, *slash = strrchr(page, '/');
    size_t length = strlen(page), ending = strlen(PICTURE);
    char *folder = slash ? strndup(page, (size_t)(slash - page) + 1) : NULL;
    bool found = length > ending && strcmp(page + length - ending, PICTURE) == 0 &&
                 folder_is_same_file(folder ? folder : ".", r->golden);
    free(folder);
    return found || is_among(page, r->golden, pictures);
}

static int look_at_all(run *r, const folder_listing *scenes, const folder_listing *pictures)
{
    r->scenes = scenes;
    if (r->plan->page && (is_scene(r, r->plan->page) || is_golden(r, pictures))) {
        complain(stderr, r->plan->page, "the page may not take the place of a scene or picture");
        return 2;
    }
    for (int i = 0; i < scenes->count; i++)
        look_at(r, scenes->names[i], false);
    for (int i = 0; i < pictures->count; i++) {
        if (!has_scene(scenes, pictures->names[i]))
            look_at(r, pictures->names[i], true);
    }
    if (r->plan->page && !regress_page_write(&r->page, r->plan->folder, &r->plan->settings,
                                             r->counts, r->plan->page))
        r->trouble = true;
    else if (!r->plan->quiet)
        print_summary(r);
    return r->trouble ? 2 : r->left ? 1 : 0;
}

static bool list_all(const regress_plan *plan, const char *golden, folder_listing *scenes,
                     folder_listing *pictures)
{
    if (!folder_list(plan->folder, "", SCENE, stderr, scenes))
        return false;
    if (scenes->count == 0)
        return complain(stderr, plan->folder, "no scene in it (*" SCENE ")");
    bool exists = access(golden, F_OK) == 0 || errno != ENOENT;
    return !exists || folder_list(golden, "", PICTURE, stderr, pictures);
}

int regress_folder(const regress_plan *plan)
{
    char *beside = folder_path(plan->folder, "golden", strlen("golden"), "");
    run r = {.plan = plan, .golden = plan->golden ? plan->golden : beside};
    folder_listing scenes = {NULL, 0}, pictures = {NULL, 0};
    int status = 2;
    if (!beside || !regress_page_open(&r.page))
        no_memory(&r);
    else if (list_all(plan, r.golden, &scenes, &pictures))
        status = look_at_all(&r, &scenes, &pictures);
    folder_free(&scenes);
    folder_free(&pictures);
    regress_page_close(&r.page);
    free(beside);
    return status;
}
