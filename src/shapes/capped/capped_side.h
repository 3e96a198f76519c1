/* On which side of a capped solid a point is. */
#ifndef SHAPES_CAPPED_SIDE_H
#define SHAPES_CAPPED_SIDE_H

/* The greatest of the signs of a solid's functions: it is outside where any is positive. */
static inline int capped_side(int before, int beyond, int body)
{
    int greater = before > beyond ? before : beyond;
    return greater > body ? greater : body;
}

#endif
