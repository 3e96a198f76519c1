#!/bin/sh
# SPDX-License-Identifier: MIT
# docs/accuracy.csv anew, of 104,466,520 cases; what was done before it was interrupted is kept.
#   again.sh CAMPAIGN HERE ROOT FOLDER
set -eu
campaign=$1 here=$2 root=$3 folder=$4
mkdir -p "$folder"
[ -e "$folder/manifest" ] || "$campaign" plan --cases 104466500 --seed 41 -o "$folder/manifest"
sh "$here" "$campaign" "$folder/manifest" "$folder/pieces" || {
    echo "again.sh: $folder is gone on with; of another program's remove it" >&2
    exit 1
}
"$campaign" merge "$folder/pieces" -o "$folder/record.json"
"$campaign" table "$folder/record.json" -o "$root/docs/accuracy.csv"
