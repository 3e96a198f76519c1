#include "surroundings.h"

#include <fenv.h>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

void surroundings_set(int number)
{
    static const int modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    fesetround(modes[number % 4]);
#ifdef __SSE2__
    const unsigned flush = 0x8040; /* FTZ and DAZ */
    _mm_setcsr((_mm_getcsr() & ~flush) | (number >= 4 ? flush : 0));
#endif
}
