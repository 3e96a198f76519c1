/* `surehit render --integrator forward`. */
#ifndef CLI_RENDER_FORWARD_H
#define CLI_RENDER_FORWARD_H

#include "render_request.h"

#define EXIT_INTERRUPTED 130 /* as a shell says of SIGINT; what was done is written */

/* Returns the exit status. */
int render_forward_placed(const args *line, const render_request *asked,
                          const placed_scene *placed);

#endif
