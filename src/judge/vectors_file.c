#include "vectors.h"

#include "../support/atomic_file.h"

#include <errno.h>
#include <string.h>

#define PATH_MOST 4096

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

static vectors_outcome refuse(const char *path, int number)
{
    fprintf(stderr, "surehit vectors: error: %s: line %d is no case\n", path, number);
    return VECTORS_NO_CASES;
}

/* The file's cases of that shape; whole lines. */
static vectors_outcome write_file(FILE *out, sure_shape shape, FILE *in, const char *path)
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
    return VECTORS_WRITTEN;
}

static vectors_outcome write_named(FILE *out, sure_shape shape, const char *path)
{
    FILE *in = fopen(path, "r");
    if (!in) {
        fprintf(stderr, "surehit vectors: error: %s: %s\n", path, strerror(errno));
        return VECTORS_NO_CASES;
    }
    vectors_outcome status = write_file(out, shape, in, path);
    if (status == VECTORS_WRITTEN && ferror(in)) {
        fprintf(stderr, "surehit vectors: error: %s: cannot be read\n", path);
        status = VECTORS_NO_CASES;
    }
    fclose(in);
    return status;
}

static vectors_outcome write_all(FILE *out, sure_shape shape, const char *const *files, int count)
{
    char head[VECTORS_LINE_MAX];
    vectors_outcome status = VECTORS_WRITTEN;
    vectors_print_head(shape, head);
    fprintf(out, "%s\n", head);
    write_regimes(out, shape);
    for (int i = 0; status == VECTORS_WRITTEN && i < count; i++)
        status = write_named(out, shape, files[i]);
    return status;
}

vectors_outcome vectors_write(sure_shape shape, const char *const *files, int count,
                              const char *folder)
{
    char path[PATH_MOST];
    atomic_file file;
    int length = snprintf(path, sizeof path, "%s/%s.jsonl", folder, sure_shape_name(shape));
    if (length >= PATH_MOST) {
        fprintf(stderr, "surehit vectors: error: too long: '%s'\n", folder);
        return VECTORS_NO_CASES;
    }
    if (!atomic_file_open(path, stderr, &file))
        return VECTORS_UNWRITTEN;
    vectors_outcome status = write_all(file.stream, shape, files, count);
    if (status != VECTORS_WRITTEN) {
        atomic_file_discard(&file);
        return status;
    }
    return atomic_file_finish(&file, stderr) ? VECTORS_WRITTEN : VECTORS_UNWRITTEN;
}
