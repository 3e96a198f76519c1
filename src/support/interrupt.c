#define _POSIX_C_SOURCE 200809L /* sigaction */
#define _DEFAULT_SOURCE         /* SA_RESTART */

#include "interrupt.h"

#include <signal.h>
#include <stddef.h>

static volatile sig_atomic_t caught;
static struct sigaction before;

static void note(int signal_number)
{
    (void)signal_number;
    caught = 1;
}

void interrupt_catch(void)
{
    struct sigaction noting = {.sa_handler = note, .sa_flags = (int)(SA_RESETHAND | SA_RESTART)};
    caught = 0;
    sigaction(SIGINT, NULL, &before);
    if (before.sa_handler == SIG_DFL)
        sigaction(SIGINT, &noting, NULL);
}

bool interrupt_caught(void)
{
    return caught != 0;
}

void interrupt_release(void)
{
    sigaction(SIGINT, &before, NULL);
}
