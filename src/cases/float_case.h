/* The cases that a routine in float can be asked. */
#ifndef CASES_FLOAT_CASE_H
#define CASES_FLOAT_CASE_H

#include "case.h"

/* Every number rounded to the nearest float. False if that makes a valid case invalid: nothing was
 * asked then. */
bool float_case(const sure_case *question, sure_case *rounded);

#endif
