#include "args.h"
#include "commands.h"

#include "../image/difference.h"
#include "../support/atomic_file.h"

#include <inttypes.h>
#include <stdio.h>

/* As of other programs that compare: 1 is for pictures that differ, all trouble is 2. */
#define EXIT_DIFFERENT 1
#define EXIT_TROUBLE 2

enum { HELP, OUTPUT, JSON };
static const args_option options[] = {
    [HELP] = {"--help", false},
    [OUTPUT] = {"-o", true},
    [JSON] = {"--json", true},
};
#define OPTIONS (int)(sizeof options / sizeof *options)

typedef struct {
    bool help;
    const char *paths[2];
    int path_count;
    const char *output, *json;
} request;

static void print_help(void)
{
    fputs("Usage: surehit diff A B [-o D.ppm|D.png] [--json FILE]\n"
          "\n"
          "Says where two pictures differ: how many pixels, by how much at most in a\n"
          "channel, and the smallest box that holds them (x, y, w, h; the origin is the\n"
          "upper left corner). A picture is a P6 PPM of 255 levels, or a PNG of up to 8\n"
          "bits a channel and without transparency, whatever its name.\n"
          "\n"
          "  -o FILE      the difference as a picture: what is the same grey and dim, from\n"
          "               A; what differs orange, the brighter the more\n"
          "  --json FILE  what is said, for programs\n"
          "\n"
          "Exit status: 0 the same; 1 different; 2 wrong usage, a picture that can't be\n"
          "read, or output that could not be written.\n",
          stdout);
}

static int add_operand(const args *line, const char *word, request *asked)
{
    if (asked->path_count == 2)
        return args_wrong(line, "a third picture", word);
    asked->paths[asked->path_count++] = word;
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
        case JSON: asked->json = value; break;
        case ARGS_OPERAND: status = add_operand(line, value, asked); break;
        default: status = EXIT_USAGE;
        }
    }
    if (status == 0 && asked->path_count < 2)
        status = args_wrong(line, "missing", asked->path_count == 0 ? "A" : "B");
    return status;
}

static bool outputs_are_possible(const request *asked)
{
    return (!asked->output || (picture_path_ok(asked->output, stderr) &&
                               atomic_file_possible(asked->output, stderr))) &&
           (!asked->json || atomic_file_possible(asked->json, stderr));
}

static void print_json(FILE *out, const difference *found)
{
    const int *a = found->sizes[0], *b = found->sizes[1];
    const pixel_box *box = &found->box;
    fprintf(out, "{\"same\": %s, \"sizes\": [[%d, %d], [%d, %d]]",
            difference_is_none(found) ? "true" : "false", a[0], a[1], b[0], b[1]);
    if (found->same_size)
        fprintf(out, ", \"pixels\": %" PRId64 ", \"largest\": %d", found->pixels, found->largest);
    if (found->same_size && found->pixels > 0)
        fprintf(out, ", \"box\": {\"x\": %d, \"y\": %d, \"w\": %d, \"h\": %d}", box->left, box->top,
                box->width, box->height);
    fputs("}\n", out);
}

static bool write_json(const char *path, const difference *found)
{
    atomic_file file;
    if (!path)
        return true;
    if (!atomic_file_open(path, stderr, &file))
        return false;
    print_json(file.stream, found);
    return atomic_file_finish(&file, stderr);
}

static bool write_picture(const char *path, const picture pair[2], const difference *found)
{
    picture shown;
    if (!path)
        return true;
    if (!found->same_size) {
        fprintf(stderr, "%s: not written: the pictures differ in size\n", path);
        return true;
    }
    if (!difference_draw(&pair[0], &pair[1], &shown)) {
        fprintf(stderr, "%s: error: no memory for this picture\n", path);
        return false;
    }
    bool written = picture_write(&shown, path, stderr);
    picture_free(&shown);
    return written;
}

static int compare(const request *asked, const picture pair[2])
{
    difference found = difference_of(&pair[0], &pair[1]);
    bool same = difference_is_none(&found);
    printf("%s and %s %s", asked->paths[0], asked->paths[1], same ? "are the same" : "differ: ");
    if (!same)
        difference_print(stdout, &found);
    putchar('\n');
    bool written = write_json(asked->json, &found);
    written = write_picture(asked->output, pair, &found) && written;
    return !written ? EXIT_TROUBLE : same ? 0 : EXIT_DIFFERENT;
}

static int read_and_compare(const request *asked)
{
    picture pair[2] = {{0}, {0}};
    bool read = picture_read(asked->paths[0], stderr, &pair[0]);
    read = picture_read(asked->paths[1], stderr, &pair[1]) && read;
    int status = read ? compare(asked, pair) : EXIT_TROUBLE;
    picture_free(&pair[0]);
    picture_free(&pair[1]);
    return status;
}

int command_diff(int count, char **words)
{
    args line = {"surehit diff", words, count, 0, false};
    request asked = {.help = false};
    int status = read_words(&line, &asked);
    if (status == 0 && asked.help)
        print_help();
    else if (status == 0)
        status = outputs_are_possible(&asked) ? read_and_compare(&asked) : EXIT_TROUBLE;
    return args_flush_output(&line, 0) == 0 ? status : EXIT_TROUBLE;
}
