# SPDX-License-Identifier: MIT
"""How what looks for something ends: 1 says that it was found."""
import sys
import traceback

NOT_LOOKED_FOR = 2


def end(main):
    """With what main returns, or with 2 where it could not look, whatever came in between."""
    try:
        status = main()
    except SystemExit as ended:
        status = ended.code
        if isinstance(status, str):
            print(status, file=sys.stderr)
            status = NOT_LOOKED_FOR
    except Exception:
        traceback.print_exc()
        status = NOT_LOOKED_FOR
    sys.exit(status)
