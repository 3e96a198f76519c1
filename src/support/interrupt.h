/* SIGINT as a wish to end soon: long work that can stop half-way asks for it. */
#ifndef SUPPORT_INTERRUPT_H
#define SUPPORT_INTERRUPT_H

#include <stdbool.h>

/* From here on a first SIGINT is noted, a second one does what it did before. Where somebody else
 * has decided what it does, as where it is ignored, that stays. */
void interrupt_catch(void);

/* Was there one since? */
bool interrupt_caught(void);

/* All is as it was before. */
void interrupt_release(void);

#endif
