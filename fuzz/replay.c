/* The plain engine, of any compiler: runs its target over files, and over all files of folders.
 * Fails on a find, by its abort; on a file that can't be read; and when nothing was compared. */
#include "fuzz.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LARGEST = 1 << 20, PATH_LONGEST = 4096 };

typedef struct {
    unsigned long inputs, compared, unread;
} counts;

/* Of its own size, so that a sanitizer sees a read past its end. */
static bool run(const char *path, FILE *file, counts *sum)
{
    static uint8_t room[LARGEST];
    size_t size = fread(room, 1, sizeof room, file);
    if (ferror(file) || !feof(file))
        return false;
    uint8_t *data = malloc(size > 0 ? size : 1);
    if (!data)
        return false;
    memcpy(data, room, size);
    if (getenv("FUZZ_VERBOSE"))
        fprintf(stderr, "%s\n", path);
    sum->inputs++;
    sum->compared += fuzz_target(data, size);
    free(data);
    return true;
}

static void run_file(const char *path, counts *sum)
{
    FILE *file = fopen(path, "rb");
    if (!file || !run(path, file, sum)) {
        fprintf(stderr, "%s: can't be read\n", path);
        sum->unread++;
    }
    if (file)
        fclose(file);
}

static void run_folder(const char *path, DIR *folder, counts *sum)
{
    const struct dirent *entry;
    while ((entry = readdir(folder)) != NULL) {
        char inside[PATH_LONGEST];
        if (entry->d_name[0] == '.')
            continue;
        if (snprintf(inside, sizeof inside, "%s/%s", path, entry->d_name) < (int)sizeof inside)
            run_file(inside, sum);
        else
            sum->unread++;
    }
}

int main(int argc, char **argv)
{
    counts sum = {0};
    for (int i = 1; i < argc; i++) {
        DIR *folder = opendir(argv[i]);
        if (folder) {
            run_folder(argv[i], folder, &sum);
            closedir(folder);
        } else {
            run_file(argv[i], &sum);
        }
    }
    printf("%s: %lu inputs, %lu compared\n", fuzz_name, sum.inputs, sum.compared);
    return sum.compared > 0 && sum.unread == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
