/* SPDX-License-Identifier: MIT */
/* The default floating-point environment for as long as this lives, the caller's own afterwards:
 * for CGAL's interval filters and MPFR, the only places where a floating-point operation may
 * happen. */
#ifndef REFERENCE_CGAL_ENVIRONMENT_H
#define REFERENCE_CGAL_ENVIRONMENT_H

#include <cfenv>

namespace exact {

class default_environment {
public:
    default_environment()
    {
        std::fegetenv(&callers_);
        std::fesetenv(FE_DFL_ENV);
    }
    ~default_environment() { std::fesetenv(&callers_); }
    default_environment(const default_environment &) = delete;
    default_environment &operator=(const default_environment &) = delete;

private:
    std::fenv_t callers_;
};

}

#endif
