/* The floating-point environments that the contract names: rounding modes, subnormals flushed or
 * not. */
#ifndef FUZZ_SURROUNDINGS_H
#define FUZZ_SURROUNDINGS_H

/* Number 0 is the usual one: to nearest, nothing flushed. */
enum { SURROUNDINGS = 8 };

void surroundings_set(int number);

#endif
