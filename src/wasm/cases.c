/* SPDX-License-Identifier: MIT */
/* Cases and answers for scripts: made, and as lines. */
#include "export.h"
#include "room.h"

#include "../cases/regimes.h"

static char line[CASE_LINE_MAX];

/* Room for a line, where scripts write what is to be read. */
char *WASM_EXPORT(line_room)(void)
{
    return line;
}

int WASM_EXPORT(line_size)(void)
{
    return CASE_LINE_MAX;
}

const char *WASM_EXPORT(regime_word)(int which)
{
    return regime_name((regime)which);
}

int WASM_EXPORT(regime_has)(sure_shape shape, int which)
{
    return regime_applies(shape, (regime)which);
}

/* Cases first, first + 1, ... of a regime, into the room. Whole numbers up to 2^53. */
void WASM_EXPORT(make_cases)(int count, sure_shape shape, int which, double seed, double first)
{
    for (int i = 0; i < count; i++) {
        const sure_case made =
            regime_case(shape, (regime)which, (uint64_t)seed, (uint64_t)first + (uint64_t)i);
        room_put(i, &made.ray, &made.object);
    }
}

static sure_case case_of_room(int i, sure_shape shape)
{
    return (sure_case){.ray = room_ray(i), .object = room_object(i, shape)};
}

/* The room's i-th case as a line. */
const char *WASM_EXPORT(case_line)(int i, sure_shape shape)
{
    const sure_case question = case_of_room(i, shape);
    case_print(&question, line);
    return line;
}

/* The tier's answer to it. */
const char *WASM_EXPORT(answer_line)(int i, sure_shape shape, sure_tier tier)
{
    const sure_case question = case_of_room(i, shape);
    const case_answer answer = case_answer_of(&question, tier);
    case_answer_print(&answer, line);
    return line;
}

/* The line's case becomes the room's first; its shape, or -1: it is no case. */
int WASM_EXPORT(case_from_line)(void)
{
    sure_case question;
    line[CASE_LINE_MAX - 1] = '\0';
    if (!case_read(line, &question))
        return -1;
    room_put(0, &question.ray, &question.object);
    return (int)question.object.shape;
}
