#include "args.h"
#include "choice.h"
#include "commands.h"

#include "../judge/vectors.h"
#include "../support/atomic_file.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#define FILES_MOST 16
#define PATH_MOST 4096

enum { HELP, SHAPE, CASES, OUTPUT };
static const args_option options[] = {
    [HELP] = {"--help", false},
    [SHAPE] = {"--shape", true},
    [CASES] = {"--cases", true},
    [OUTPUT] = {"-o", true},
};
#define OPTIONS (int)(sizeof options / sizeof *options)

typedef struct {
    args line;
    bool help;
    choice shapes;
    const char *files[FILES_MOST];
    int file_count;
    const char *folder;
} request;

static void print_help(void)
{
    printf("Usage: surehit vectors [--shape SHAPE ...] [--cases FILE ...] [-o FOLDER]\n"
           "\n"
           "Writes hard cases with their exact answers, for tests in any language, to\n"
           "SHAPE.jsonl: one JSON object a line, the format's version in the first.\n"
           "They are the first %d of each regime with seed %d, the same on every machine.\n"
           "\n"
           "  --shape SHAPE  plane, disc, sphere, cylinder or cone (default: all)\n"
           "  --cases FILE   then these cases of the shape, one a line; \" -> \" and what\n"
           "                 follows, empty lines and lines from # on are passed over\n"
           "  -o FOLDER      where the files go (default: here)\n"
           "\n"
           "--shape and --cases may be repeated.\n"
           "\n"
           "Exit status: 0 written; 1 not written; 2 wrong usage, or no such cases.\n",
           VECTORS_PER_REGIME, VECTORS_VERSION);
}

static int add_file(request *asked, const char *path)
{
    if (asked->file_count == FILES_MOST)
        return args_wrong(&asked->line, "one file too many:", path);
    asked->files[asked->file_count++] = path;
    return 0;
}

static int read_words(request *asked)
{
    const char *value;
    int status = 0, option;
    while (status == 0 &&
           (option = args_next(&asked->line, options, OPTIONS, &value)) != ARGS_END) {
        switch (option) {
        case HELP: asked->help = true; return 0;
        case SHAPE: status = choice_add_shape(&asked->line, value, &asked->shapes); break;
        case CASES: status = add_file(asked, value); break;
        case OUTPUT: asked->folder = value; break;
        case ARGS_OPERAND: status = args_wrong(&asked->line, "one word too many:", value); break;
        default: status = EXIT_USAGE;
        }
    }
    return status;
}

static void write_line(FILE *out, const frozen_case *frozen)
{
    char line[VECTORS_LINE_MAX];
    vectors_print(frozen, line);
    fprintf(out, "%s\n", line);
}

static void write_regimes(FILE *out, sure_shape shape)
{
    for (int which = 0; which < REGIMES; which++) {
        if (!regime_applies(shape, (regime)which))
            continue;
        for (uint64_t i = 0; i < VECTORS_PER_REGIME; i++) {
            frozen_case frozen = vectors_case(shape, (regime)which, i);
            write_line(out, &frozen);
        }
    }
}

/* Only what a JSON string may hold as it is. */
static const char *source_of(const char *path)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    for (const char *at = name; *at != '\0'; at++) {
        if (*at < ' ' || *at > '~' || *at == '"' || *at == '\\')
            return "cases";
    }
    return name;
}

/* What is before " -> ". Is there a case in it? */
static bool cut_case(char *line)
{
    char *answer = strstr(line, " -> ");
    if (answer)
        *answer = '\0';
    return line[0] != '#' && line[0] != '\n' && line[0] != '\0';
}

static int refuse(const char *path, int number)
{
    fprintf(stderr, "surehit vectors: error: %s: line %d is no case\n", path, number);
    return EXIT_USAGE;
}

/* The file's cases of that shape; whole lines. */
static int write_file(FILE *out, sure_shape shape, FILE *in, const char *path)
{
    char line[2 * CASE_LINE_MAX];
    for (int number = 1; fgets(line, sizeof line, in); number++) {
        sure_case question;
        if (!strchr(line, '\n') && !feof(in))
            return refuse(path, number);
        if (!cut_case(line))
            continue;
        if (!case_read(line, &question))
            return refuse(path, number);
        if (question.object.shape != shape)
            continue;
        frozen_case frozen = vectors_case_of(source_of(path), (uint64_t)number, &question);
        write_line(out, &frozen);
    }
    return 0;
}

static int write_named(FILE *out, sure_shape shape, const char *path)
{
    FILE *in = fopen(path, "r");
    if (!in) {
        fprintf(stderr, "surehit vectors: error: %s: %s\n", path, strerror(errno));
        return EXIT_USAGE;
    }
    int status = write_file(out, shape, in, path);
    if (status == 0 && ferror(in)) {
        fprintf(stderr, "surehit vectors: error: %s: cannot be read\n", path);
        status = EXIT_USAGE;
    }
    fclose(in);
    return status;
}

static int write_all(const request *asked, FILE *out, sure_shape shape)
{
    char head[VECTORS_LINE_MAX];
    int status = 0;
    vectors_print_head(shape, head);
    fprintf(out, "%s\n", head);
    write_regimes(out, shape);
    for (int i = 0; status == 0 && i < asked->file_count; i++)
        status = write_named(out, shape, asked->files[i]);
    return status;
}

static int write_shape(const request *asked, sure_shape shape)
{
    char path[PATH_MOST];
    atomic_file file;
    int length = snprintf(path, sizeof path, "%s/%s.jsonl", asked->folder, sure_shape_name(shape));
    if (length >= PATH_MOST)
        return args_wrong(&asked->line, "too long:", asked->folder);
    if (!atomic_file_open(path, stderr, &file))
        return EXIT_OUTPUT;
    int status = write_all(asked, file.stream, shape);
    if (status != 0) {
        atomic_file_discard(&file);
        return status;
    }
    return atomic_file_finish(&file, stderr) ? 0 : EXIT_OUTPUT;
}

int command_vectors(int count, char **words)
{
    request asked = {.line = {"surehit vectors", words, count, 0, false}, .folder = "."};
    int status = read_words(&asked);
    if (status != 0)
        return status;
    if (asked.help) {
        print_help();
        return args_flush_output(&asked.line, 0);
    }
    for (int shape = 0; status == 0 && shape < SURE_SHAPES; shape++) {
        if (asked.shapes.shapes[shape] || !asked.shapes.some_shapes)
            status = write_shape(&asked, (sure_shape)shape);
    }
    return status;
}
