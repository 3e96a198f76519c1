/* SPDX-License-Identifier: MIT */
#include "atomic_file.h"

#include "complain.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* The length of the folder's name that `path` begins with, with its slash: 0 for none. */
static int folder_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? (int)(slash - path) + 1 : 0;
}

/* How it is refused is told by errno, where that says more. */
static bool fail(const char *path, FILE *messages, const char *what)
{
    return complain(messages, path, "%s: %s", what, strerror(errno));
}

/* May a file take the place of what is at `target`, of that mode, or 0 where nothing is? */
static bool replaceable(const char *path, const char *target, FILE *messages, mode_t mode)
{
    char folder[PATH_MAX];
    if (mode == 0 && errno != ENOENT)
        return fail(path, messages, "cannot be written");
    if (S_ISDIR(mode))
        return complain(messages, path, "is a directory");
    if (S_ISFIFO(mode))
        return access(target, W_OK) == 0 || fail(path, messages, "cannot be written");
    if (mode != 0 && !S_ISREG(mode))
        return complain(messages, path, "is a device or socket, which is never replaced");
    if (mode != 0 && access(target, W_OK) != 0)
        return fail(path, messages, "cannot be replaced");
    snprintf(folder, sizeof folder, "%.*s.", folder_of(target), target);
    return access(folder, W_OK | X_OK) == 0 || fail(path, messages, "cannot write to its folder");
}

/* Where the file goes, to be freed, and the mode of what is there; NULL after a complaint. */
static char *find_target(const char *path, FILE *messages, mode_t *mode)
{
    struct stat found;
    bool link = lstat(path, &found) == 0 && S_ISLNK(found.st_mode);
    char *target = link ? realpath(path, NULL) : strdup(path);
    if (!target) {
        fail(path, messages, link ? "cannot follow the link" : "cannot be written");
        return NULL;
    }
    *mode = stat(target, &found) == 0 ? found.st_mode : 0;
    if (replaceable(path, target, messages, *mode))
        return target;
    free(target);
    return NULL;
}

bool atomic_file_possible(const char *path, FILE *messages)
{
    mode_t mode;
    char *target = path ? find_target(path, messages, &mode) : NULL;
    free(target);
    return !path || target;
}

/* Static, so that a signal can find it at any moment. */
static char temporary[PATH_MAX];

static const int deadly[] = {SIGHUP, SIGINT, SIGQUIT, SIGTERM};
#define DEADLY (sizeof deadly / sizeof *deadly)

static struct sigaction deadly_before[DEADLY], size_limit_before;

/* SA_RESETHAND has put the default back, so the signal raised here ends the program. */
static void remove_and_die(int signal_number)
{
    unlink(temporary);
    raise(signal_number);
}

/* Only where nobody else has decided what the signal does: an ignored hangup stays ignored. */
static void guard(void)
{
    struct sigaction removing = {.sa_handler = remove_and_die, .sa_flags = (int)SA_RESETHAND};
    for (size_t i = 0; i < DEADLY; i++) {
        sigaction(deadly[i], NULL, &deadly_before[i]);
        if (deadly_before[i].sa_handler == SIG_DFL)
            sigaction(deadly[i], &removing, NULL);
    }
    struct sigaction ignoring = {.sa_handler = SIG_IGN};
    sigaction(SIGXFSZ, &ignoring, &size_limit_before); /* write then fails with EFBIG */
}

static void unguard(void)
{
    for (size_t i = 0; i < DEADLY; i++)
        sigaction(deadly[i], &deadly_before[i], NULL);
    sigaction(SIGXFSZ, &size_limit_before, NULL);
}

/* Creates a file of a name that nobody has, beside `target`: its descriptor, or -1 and errno. The
 * name is short whatever the target's own length, so that it fits where the target does. */
static int create_temporary(const char *target, mode_t mode)
{
    for (unsigned attempt = 0;; attempt++) {
        int size = snprintf(temporary, sizeof temporary, "%.*s.surehit-%ld-%u.part",
                            folder_of(target), target, (long)getpid(), attempt);
        bool fits = (size_t)size < sizeof temporary;
        int descriptor = fits ? open(temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode) : -1;
        if (!fits)
            errno = ENAMETOOLONG;
        if (descriptor != -1 || errno != EEXIST)
            return descriptor;
    }
}

/* Nothing takes the place of a pipe: who reads it gets what is written at once. */
static bool open_pipe(const char *path, FILE *messages, char *target, atomic_file *file)
{
    *file = (atomic_file){fopen(target, "wb"), path, NULL};
    free(target);
    return file->stream || fail(path, messages, "cannot be written");
}

bool atomic_file_open(const char *path, FILE *messages, atomic_file *file)
{
    mode_t mode;
    char *target = find_target(path, messages, &mode);
    if (!target || S_ISFIFO(mode))
        return target && open_pipe(path, messages, target, file);
    guard(); /* first: a signal finds nothing, or a file that is to be removed */
    int descriptor = create_temporary(target, mode != 0 ? mode & 0777 : 0666);
    if (descriptor == -1) {
        fail(path, messages, "cannot be written");
        unguard();
        free(target);
        return false;
    }
    if (mode != 0)
        fchmod(descriptor, mode & 0777); /* should this fail, the umask has only taken from it */
    *file = (atomic_file){fdopen(descriptor, "wb"), path, target};
    if (file->stream)
        return true;
    fail(path, messages, "cannot be written");
    close(descriptor);
    atomic_file_discard(file);
    return false;
}

const char *stream_reason(FILE *stream)
{
    errno = 0;
    return write(fileno(stream), "\n", 1) == 1 || errno == 0 ? "for a reason that has passed"
                                                             : strerror(errno);
}

/* Its bytes are on the disk before its name is: whole or not at all, also where the power fails. */
static bool put_in_place(atomic_file *file)
{
    bool kept = fflush(file->stream) == 0 &&
                (!file->target || fsync(fileno(file->stream)) == 0 || errno == EINVAL);
    kept = fclose(file->stream) == 0 && kept;
    file->stream = NULL;
    return kept && (!file->target || rename(temporary, file->target) == 0);
}

bool atomic_file_finish(atomic_file *file, FILE *messages)
{
    bool failed = ferror(file->stream) != 0;
    if (failed)
        complain(messages, file->path, "cannot be written: %s", stream_reason(file->stream));
    bool placed =
        !failed && (put_in_place(file) || fail(file->path, messages, "cannot be written"));
    atomic_file_discard(file);
    return placed;
}

void atomic_file_discard(atomic_file *file)
{
    if (file->stream)
        fclose(file->stream);
    if (!file->target)
        return;
    unlink(temporary); /* after a rename there is nothing of that name */
    unguard();
    free(file->target);
}
