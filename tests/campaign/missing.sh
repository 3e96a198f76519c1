#!/bin/sh
# SPDX-License-Identifier: MIT
# The numbers of the pieces that a manifest's folder lacks, one a line.
#   missing.sh CAMPAIGN MANIFEST FOLDER
set -eu
missing=$("$1" status "$2" "$3") || [ $? -eq 3 ]
echo "$missing" | tr , '\n' | while IFS=- read -r first last; do
    [ -z "$first" ] || seq "$first" "${last:-$first}"
done
