#include "../../numbers/valid.h"
#include "where.h"

#include "../../numbers/environment.h"

#include <assert.h>

static NOT_INLINED int exactly(const shape_row *row, const void *shape, sure_vec3 p)
{
    exact_arena room;
    exact_context c = exact_start(&room);
    return row->surface->side_exact(&c, shape, p);
}

int where_is(const shape_row *row, const void *shape, sure_vec3 p)
{
    assert(environment_is_nearest() && all_finite(p));
    ddb_context c = {false};
    int side = row->surface->side_ddb(&c, shape, p);
    return c.uncertain ? exactly(row, shape, p) : side;
}
