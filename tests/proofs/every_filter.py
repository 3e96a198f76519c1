# SPDX-License-Identifier: MIT
"""The header that includes the first stage's header of each of the shapes."""

import sys

for shape in sys.argv[1:]:
    print(f'#include "shapes/{shape}/{shape}_filter.h"')
