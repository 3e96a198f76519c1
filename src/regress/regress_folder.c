#define _POSIX_C_SOURCE 200809L /* mkdir, access */

#include "regress.h"

#include "../scene/rt_notes.h"
#include "../support/folder.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define SCENE ".rt"
#define PICTURE ".png"

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
    regress_page page;
    int counts[REGRESS_VERDICTS];
    bool trouble; /* something could not be read or written */
    bool left;    /* something differs, is new or stale, and was not accepted */
} run;

static regress_outcome no_memory(void)
{
    fputs("surehit regress: error: no memory\n", stderr);
    return REGRESSED_TROUBLE;
}

static bool complain(const char *path, const char *what)
{
    fprintf(stderr, "%s: error: cannot be %s: %s\n", path, what, strerror(errno));
    return false;
}

/* What a scene was renamed from goes only when all that there is now has been written. */
static const char *accept_stale(run *r, const char *golden)
{
    if (r->trouble)
        return "kept, since not all went well";
    if (unlink(golden) == 0 || complain(golden, "removed"))
        return "removed";
    r->trouble = true;
    return "not removed";
}

static const char *accept_picture(run *r, const char *golden, const regression *found)
{
    bool made = mkdir(r->golden, 0777) == 0 || errno == EEXIST || complain(r->golden, "made");
    if (made && picture_write(&found->got, golden, stderr))
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
        return verdict == REGRESS_STALE ? accept_stale(r, golden)
                                        : accept_picture(r, golden, found);
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
    size_t stem = strlen(name) - strlen(is_stale ? PICTURE : SCENE);
    char *scene = folder_path(r->plan->folder, name, stem, SCENE);
    char *golden = folder_path(r->golden, name, stem, PICTURE), *shown = rt_printable_name(name);
    regression found;
    if (scene && golden && shown &&
        regress(is_stale ? NULL : scene, golden, &r->plan->settings, &found)) {
        fputs(found.messages, stderr);
        report(r, shown, &found, settle(r, golden, &found));
        regress_free(&found);
    } else {
        no_memory();
        r->trouble = true;
    }
    free(scene);
    free(golden);
    free(shown);
}

static void print_summary(const run *r)
{
    regress_print_counts(stdout, r->counts);
    if (r->plan->page)
        printf("; see %s", r->plan->page);
    else if (r->left)
        printf("; -o PAGE.html shows it, --accept makes it golden");
    putchar('\n');
}

static regress_outcome look_at_all(run *r, const folder_listing *scenes,
                                   const folder_listing *pictures)
{
    for (int i = 0; i < scenes->count; i++)
        look_at(r, scenes->names[i], false);
    for (int i = 0; i < pictures->count; i++) {
        if (!has_scene(scenes, pictures->names[i]))
            look_at(r, pictures->names[i], true);
    }
    if (r->plan->page && !regress_page_write(&r->page, r->plan->folder, &r->plan->settings,
                                             r->counts, r->plan->page, stderr))
        r->trouble = true;
    else if (!r->plan->quiet)
        print_summary(r);
    return r->trouble ? REGRESSED_TROUBLE : r->left ? REGRESSED_LEFT : REGRESSED_SAME;
}

static bool list_all(const regress_plan *plan, const char *golden, folder_listing *scenes,
                     folder_listing *pictures)
{
    if (!folder_list(plan->folder, "", SCENE, stderr, scenes))
        return false;
    if (scenes->count == 0) {
        fprintf(stderr, "%s: error: no scene in it (*" SCENE ")\n", plan->folder);
        return false;
    }
    bool exists = access(golden, F_OK) == 0 || errno != ENOENT;
    return !exists || folder_list(golden, "", PICTURE, stderr, pictures);
}

static regress_outcome run_in(const regress_plan *plan, const char *golden)
{
    run r = {.plan = plan, .golden = golden};
    folder_listing scenes = {NULL, 0}, pictures = {NULL, 0};
    regress_outcome outcome = REGRESSED_TROUBLE;
    if (!regress_page_open(&r.page))
        return no_memory();
    if (list_all(plan, golden, &scenes, &pictures))
        outcome = look_at_all(&r, &scenes, &pictures);
    folder_free(&scenes);
    folder_free(&pictures);
    regress_page_close(&r.page);
    return outcome;
}

regress_outcome regress_folder(const regress_plan *plan)
{
    char *beside = folder_path(plan->folder, "golden", strlen("golden"), "");
    regress_outcome outcome =
        beside ? run_in(plan, plan->golden ? plan->golden : beside) : no_memory();
    free(beside);
    return outcome;
}
