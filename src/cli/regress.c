#define _XOPEN_SOURCE 700 /* scandir, isatty, strndup */

#include "args.h"
#include "commands.h"
#include "drawing.h"

#include "../tracer/regress/regress_page.h"
#include "../scene/rt_notes.h"
#include "../support/atomic_file.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* As of other programs that compare: 1 is for scenes that differ, all trouble is 2. */
#define EXIT_DIFFERENT 1
#define EXIT_TROUBLE 2

#ifdef SUREHIT_PNG
static const bool has_png = true;
#else
static const bool has_png = false;
#endif

#define SCENE ".rt"
#define PICTURE ".png"

enum { HELP, OUTPUT, QUIET, GOLDEN, ACCEPT, DRAWING };
static const args_option options[] = {
    [HELP] = {"--help", false},    [OUTPUT] = {"-o", true},        [QUIET] = {"--quiet", false},
    [GOLDEN] = {"--golden", true}, [ACCEPT] = {"--accept", false}, [DRAWING] = DRAWING_OPTIONS,
};
#define OPTIONS (int)(sizeof options / sizeof *options)

typedef struct {
    bool help, quiet, accept;
    const char *folder, *golden, *output;
    render_settings settings;
} request;

static void print_help(void)
{
    fputs("Usage: surehit regress DIR [-o PAGE.html] [--accept] [OPTION ...]\n"
          "\n"
          "Draws every scene (*.rt) of a folder and holds it against its golden picture,\n"
          "the one that was looked at and found right. Says what differs, what has no\n"
          "golden picture yet, and which golden picture (*.png) has no scene any more.\n"
          "\n"
          "  --golden DIR2    where the golden pictures are (default: DIR/golden)\n"
          "  -o FILE          a page that shows what differs; it needs no other file\n"
          "  --accept         what is drawn now becomes golden, where it differs or is new;\n"
          "                   golden pictures without a scene are removed\n",
          stdout);
    drawing_print_help();
    fputs("  --quiet          no word of what is the same\n"
          "How scenes are meant: the options of `surehit render`, such as --fov vertical.\n"
          "\n"
          "A scene's picture is the same, bit for bit, on every machine, whatever its\n"
          "compiler, C library and number of threads: nothing but + - * / and square roots\n"
          "goes into it. So the comparison is exact, and what differs is a change of scene,\n"
          "settings or surehit.\n"
          "\n"
          "Exit status: 0 all the same, or accepted; 1 something differs, is new or stale;\n"
          "2 wrong usage, or something could not be read or written.\n",
          stdout);
}

/* The words. */

static int set_folder(const args *line, const char *word, request *asked)
{
    if (asked->folder)
        return args_wrong(line, "a second folder", word);
    asked->folder = word;
    return 0;
}

/* Returns the exit status, 0 to go on. */
static int read_words(args *line, request *asked)
{
    const char *value;
    int status = 0, option;
    while (status == 0 && (option = args_next(line, options, OPTIONS, &value)) != ARGS_END) {
        switch (option) {
        case HELP: asked->help = true; return 0;
        case OUTPUT: asked->output = value; break;
        case QUIET: asked->quiet = true; break;
        case GOLDEN: asked->golden = value; break;
        case ACCEPT: asked->accept = true; break;
        case ARGS_OPERAND: status = set_folder(line, value, asked); break;
        case ARGS_WRONG: status = EXIT_USAGE; break;
        default: status = drawing_set(line, options[option].name, value, &asked->settings);
        }
    }
    if (status == 0 && !asked->folder)
        status = args_wrong(line, "missing", "DIR");
    return status;
}

/* Names and folders. */

typedef struct {
    struct dirent **entries;
    int count;
} listing;

static bool has_ending(const struct dirent *entry, const char *ending)
{
    size_t length = strlen(entry->d_name), size = strlen(ending);
    return entry->d_name[0] != '.' && length > size &&
           strcmp(entry->d_name + length - size, ending) == 0;
}

static int is_scene(const struct dirent *entry)
{
    return has_ending(entry, SCENE);
}

static int is_picture(const struct dirent *entry)
{
    return has_ending(entry, PICTURE);
}

/* The same order in every locale. */
static int by_bytes(const struct dirent **a, const struct dirent **b)
{
    return strcmp((*a)->d_name, (*b)->d_name);
}

static bool list(const char *folder, int (*wanted)(const struct dirent *), listing *found)
{
    found->count = scandir(folder, &found->entries, wanted, by_bytes);
    if (found->count >= 0)
        return true;
    *found = (listing){NULL, 0};
    fprintf(stderr, "%s: error: cannot be read: %s\n", folder, strerror(errno));
    return false;
}

static void free_listing(listing *of)
{
    for (int i = 0; i < of->count; i++)
        free(of->entries[i]);
    free(of->entries);
}

/* folder/stem.ending of a name, to be freed; NULL when there is no memory. */
static char *path_of(const char *folder, const char *name, size_t stem, const char *ending)
{
    size_t length = strlen(folder);
    const char *between = length > 0 && folder[length - 1] == '/' ? "" : "/";
    size_t size = length + stem + strlen(ending) + 2;
    char *path = malloc(size);
    if (path)
        snprintf(path, size, "%s%s%.*s%s", folder, between, (int)stem, name, ending);
    return path;
}

static bool has_scene(const listing *scenes, const char *picture_name)
{
    size_t stem = strlen(picture_name) - strlen(PICTURE);
    for (int i = 0; i < scenes->count; i++) {
        const char *name = scenes->entries[i]->d_name;
        if (strlen(name) == stem + strlen(SCENE) && strncmp(name, picture_name, stem) == 0)
            return true;
    }
    return false;
}

/* A run over the folder. */

typedef struct {
    const request *asked;
    const char *golden; /* the folder */
    regress_page page;
    int counts[REGRESS_VERDICTS];
    bool trouble; /* something could not be read or written */
    bool left;    /* something differs, is new or stale, and was not accepted */
} run;

static int fail(const char *message)
{
    fprintf(stderr, "surehit regress: error: %s\n", message);
    return EXIT_TROUBLE;
}

static bool make_folder(const char *path)
{
    if (mkdir(path, 0777) == 0 || errno == EEXIST)
        return true;
    fprintf(stderr, "%s: error: cannot be made: %s\n", path, strerror(errno));
    return false;
}

static bool remove_picture(const char *path)
{
    if (unlink(path) == 0)
        return true;
    fprintf(stderr, "%s: error: cannot be removed: %s\n", path, strerror(errno));
    return false;
}

/* What a scene was renamed from goes only when all that there is now has been written. */
static const char *accept_stale(run *r, const char *golden)
{
    if (r->trouble)
        return "kept, since not all went well";
    if (remove_picture(golden))
        return "removed";
    r->trouble = true;
    return "not removed";
}

static const char *accept_picture(run *r, const char *golden, const regression *found)
{
    if (make_folder(r->golden) && picture_write(&found->got, golden, stderr))
        return "accepted";
    r->trouble = true;
    return "not accepted";
}

/* What was done about it, or NULL; keeps account of what is left. */
static const char *settle(run *r, const char *golden, const regression *found)
{
    regress_verdict verdict = found->verdict;
    if (verdict == REGRESS_SAME)
        return NULL;
    if (verdict == REGRESS_BAD_SCENE || (verdict == REGRESS_BAD_GOLDEN && !r->asked->accept)) {
        r->trouble = true;
        return NULL;
    }
    if (r->asked->accept)
        return verdict == REGRESS_STALE ? accept_stale(r, golden)
                                        : accept_picture(r, golden, found);
    r->left = true;
    return NULL;
}

static void report(run *r, const char *name, const regression *found, const char *remark)
{
    r->counts[found->verdict]++;
    if (r->asked->output)
        regress_page_add(&r->page, name, found, remark);
    if (r->asked->quiet && found->verdict == REGRESS_SAME)
        return;
    printf("%s: ", name);
    regress_print_verdict(stdout, found);
    printf("%s%s\n", remark ? "; " : "", remark ? remark : "");
    fflush(stdout); /* between the lines of the readers, on another stream */
}

/* `scene` is NULL for a golden picture without one. */
static bool look_at(run *r, const char *scene, const char *golden, const char *name)
{
    regression found;
    char *shown = rt_printable_name(name);
    bool looked = shown && regress(scene, golden, &r->asked->settings, &found);
    if (looked) {
        fputs(found.messages, stderr);
        report(r, shown, &found, settle(r, golden, &found));
        regress_free(&found);
    }
    free(shown);
    return looked;
}

static void look_at_name(run *r, const char *name, bool is_stale)
{
    size_t stem = strlen(name) - strlen(is_stale ? PICTURE : SCENE);
    char *scene = path_of(r->asked->folder, name, stem, SCENE);
    char *golden = path_of(r->golden, name, stem, PICTURE);
    if (!scene || !golden || !look_at(r, is_stale ? NULL : scene, golden, name)) {
        fail("no memory");
        r->trouble = true;
    }
    free(scene);
    free(golden);
}

static void print_summary(const run *r)
{
    regress_print_counts(stdout, r->counts);
    if (r->asked->output)
        printf("; see %s", r->asked->output);
    else if (r->left)
        printf("; -o PAGE.html shows it, --accept makes it golden");
    putchar('\n');
}

static int look_at_all(run *r, const listing *scenes, const listing *pictures)
{
    for (int i = 0; i < scenes->count; i++)
        look_at_name(r, scenes->entries[i]->d_name, false);
    for (int i = 0; i < pictures->count; i++) {
        if (!has_scene(scenes, pictures->entries[i]->d_name))
            look_at_name(r, pictures->entries[i]->d_name, true);
    }
    if (r->asked->output && !regress_page_write(&r->page, r->asked->folder, &r->asked->settings,
                                                r->counts, r->asked->output, stderr))
        r->trouble = true;
    else if (!r->asked->quiet)
        print_summary(r);
    return r->trouble ? EXIT_TROUBLE : r->left ? EXIT_DIFFERENT : 0;
}

static bool list_all(const request *asked, const char *golden, listing *scenes, listing *pictures)
{
    if (!list(asked->folder, is_scene, scenes))
        return false;
    if (scenes->count == 0) {
        fprintf(stderr, "%s: error: no scene in it (*" SCENE ")\n", asked->folder);
        return false;
    }
    bool exists = access(golden, F_OK) == 0 || errno != ENOENT;
    return !exists || list(golden, is_picture, pictures);
}

static int run_in(const request *asked, const char *golden)
{
    run r = {.asked = asked, .golden = golden};
    listing scenes = {NULL, 0}, pictures = {NULL, 0};
    int status = EXIT_TROUBLE;
    if (!regress_page_open(&r.page))
        return fail("no memory");
    if (list_all(asked, golden, &scenes, &pictures))
        status = look_at_all(&r, &scenes, &pictures);
    free_listing(&scenes);
    free_listing(&pictures);
    regress_page_close(&r.page);
    return status;
}

static int answer(request *asked)
{
    if (!has_png)
        return fail("golden pictures are PNG, which this build can't read");
    if (asked->output && !atomic_file_possible(asked->output, stderr))
        return EXIT_TROUBLE;
    asked->settings.how.progress = !asked->quiet && isatty(STDERR_FILENO);
    char *beside = path_of(asked->folder, "golden", strlen("golden"), "");
    int status = beside ? run_in(asked, asked->golden ? asked->golden : beside) : fail("no memory");
    free(beside);
    return status;
}

int command_regress(int count, char **words)
{
    args line = {"surehit regress", words, count, 0, false};
    request asked = {.settings = render_defaults()};
    int status = read_words(&line, &asked);
    if (status == 0 && asked.help)
        print_help();
    else if (status == 0)
        status = answer(&asked);
    return args_flush_output(&line, 0) == 0 ? status : EXIT_TROUBLE;
}
