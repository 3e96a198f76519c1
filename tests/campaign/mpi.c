/* SPDX-License-Identifier: MIT */
/* Pieces by MPI, for sites where that is the way in: whichever rank is free takes the next one of
 * the NUMBERs, which missing.sh prints (docs/cluster.md).
 *
 *     mpirun campaign-mpi CAMPAIGN MANIFEST FOLDER NUMBER... */
#define _GNU_SOURCE
#include <mpi.h>
#include <spawn.h>
#include <stdio.h>
#include <sys/wait.h>

extern char **environ;

/* 1, or 0 where `campaign work` did not end well. */
static int work(char **words, char *number)
{
    char *command[] = {words[1], "work", words[2], number, words[3], NULL};
    pid_t child;
    int ended;
    return posix_spawnp(&child, words[1], NULL, NULL, command, environ) == 0 &&
           waitpid(child, &ended, 0) == child && WIFEXITED(ended) && WEXITSTATUS(ended) == 0;
}

/* The next number's place; `counter` is rank 0's. */
static int take(MPI_Win counter)
{
    const int one = 1;
    int at;
    MPI_Win_lock(MPI_LOCK_SHARED, 0, 0, counter);
    MPI_Fetch_and_op(&one, &at, MPI_INT, 0, 0, MPI_SUM, counter);
    MPI_Win_unlock(0, counter);
    return at;
}

int main(int argc, char **argv)
{
    int rank, *next, done = 0, all = 0;
    MPI_Win counter;
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (argc < 4) {
        fputs("usage: campaign-mpi CAMPAIGN MANIFEST FOLDER NUMBER...\n", stderr);
        MPI_Abort(MPI_COMM_WORLD, 2);
    }
    MPI_Win_allocate(sizeof *next, sizeof *next, MPI_INFO_NULL, MPI_COMM_WORLD, &next, &counter);
    MPI_Win_lock(MPI_LOCK_EXCLUSIVE, rank, 0, counter);
    *next = 4; /* the first NUMBER's */
    MPI_Win_unlock(rank, counter);
    MPI_Barrier(MPI_COMM_WORLD);
    for (int at = take(counter); at < argc; at = take(counter))
        done += work(argv, argv[at]);
    MPI_Reduce(&done, &all, 1, MPI_INT, MPI_SUM, 0, MPI_COMM_WORLD);
    MPI_Win_free(&counter);
    MPI_Finalize();
    if (rank == 0)
        fprintf(stderr, "%d of %d pieces were worked off\n", all, argc - 4);
    return rank == 0 && all < argc - 4;
}
