#define _XOPEN_SOURCE 700 /* realpath and what POSIX.1-2008 has */

#include "atomic_file.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool complain(const char *path, FILE *messages, const char *what, int error)
{
    fprintf(messages, "%s: error: %s", path, what);
    if (error != 0)
        fprintf(messages, ": %s", strerror(error));
    fputc('\n', messages);
    return false;
}

/* The folder that holds `path`, with its slash: the first *length characters; "./" for none. */
static const char *folder_of(const char *path, size_t *length)
{
    const char *slash = strrchr(path, '/');
    *length = slash ? (size_t)(slash - path) + 1 : 2;
    return slash ? path : "./";
}

static bool folder_writable(const char *path, const char *target, FILE *messages)
{
    char folder[PATH_MAX];
    size_t length;
    const char *start = folder_of(target, &length);
    snprintf(folder, sizeof folder, "%.*s", (int)length, start);
    return access(folder, W_OK | X_OK) == 0 ||
           complain(path, messages, "cannot write to its folder", errno);
}

/* Where the file goes, to be freed, and the permissions it gets; NULL after a complaint. */
static char *find_target(const char *path, FILE *messages, bool *exists, mode_t *mode)
{
    struct stat found;
    bool link = lstat(path, &found) == 0 && S_ISLNK(found.st_mode);
    char *target = link ? realpath(path, NULL) : strdup(path);
    if (!target) {
        complain(path, messages, link ? "cannot follow the link" : "cannot be written", errno);
        return NULL;
    }
    *exists = stat(target, &found) == 0;
    *mode = *exists ? found.st_mode & 0777 : 0666;
    bool fits;
    if (!*exists && errno != ENOENT)
        fits = complain(path, messages, "cannot be written", errno);
    else if (*exists && S_ISDIR(found.st_mode))
        fits = complain(path, messages, "is a directory", 0);
    else if (*exists && !S_ISREG(found.st_mode))
        fits = complain(path, messages, "is a device, pipe or socket, which is never replaced", 0);
    else if (*exists && access(target, W_OK) != 0)
        fits = complain(path, messages, "cannot be replaced", errno);
    else
        fits = folder_writable(path, target, messages);
    if (fits)
        return target;
    free(target);
    return NULL;
}

bool atomic_file_possible(const char *path, FILE *messages)
{
    bool exists;
    mode_t mode;
    char *target = path ? find_target(path, messages, &exists, &mode) : NULL;
    free(target);
    return !path || target;
}

/* Static, so that a signal can find it at any moment. */
static char temporary[PATH_MAX];

static const int deadly[] = {SIGHUP, SIGINT, SIGTERM};
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
    size_t length;
    const char *folder = folder_of(target, &length);
    if (length >= sizeof temporary) {
        errno = ENAMETOOLONG;
        return -1;
    }
    memcpy(temporary, folder, length);
    for (unsigned attempt = 0;; attempt++) {
        int size = snprintf(temporary + length, sizeof temporary - length, ".surehit-%ld-%u.part",
                            (long)getpid(), attempt);
        if ((size_t)size >= sizeof temporary - length) {
            errno = ENAMETOOLONG;
            return -1;
        }
        int descriptor = open(temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        if (descriptor != -1 || errno != EEXIST)
            return descriptor;
    }
}

bool atomic_file_open(const char *path, FILE *messages, atomic_file *file)
{
    bool exists;
    mode_t mode;
    char *target = find_target(path, messages, &exists, &mode);
    if (!target)
        return false;
    int descriptor = create_temporary(target, mode);
    if (descriptor == -1) {
        complain(path, messages, "cannot be written", errno);
        free(target);
        return false;
    }
    guard();
    if (exists)
        fchmod(descriptor, mode); /* should this fail, the umask has only taken from `mode` */
    *file = (atomic_file){fdopen(descriptor, "wb"), path, target};
    if (file->stream)
        return true;
    complain(path, messages, "cannot be written", errno);
    close(descriptor);
    atomic_file_discard(file);
    return false;
}

bool atomic_file_finish(atomic_file *file, FILE *messages)
{
    bool failed = ferror(file->stream) != 0;
    bool placed = fclose(file->stream) == 0 && !failed && rename(temporary, file->target) == 0;
    file->stream = NULL;
    if (!placed)
        complain(file->path, messages, "cannot be written", failed ? 0 : errno);
    atomic_file_discard(file);
    return placed;
}

void atomic_file_discard(atomic_file *file)
{
    if (file->stream)
        fclose(file->stream);
    unlink(temporary); /* after a rename there is nothing of that name */
    unguard();
    free(file->target);
}
