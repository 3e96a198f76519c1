#!/bin/sh
# SPDX-License-Identifier: MIT
# Works off what a manifest's folder lacks, on all cores of this machine.
#   here.sh CAMPAIGN MANIFEST FOLDER
set -eu
campaign=$1 manifest=$2 folder=$3
mkdir -p "$folder"
missing=$("$campaign" status "$manifest" "$folder") || [ $? -eq 3 ]
echo "$missing" | tr , '\n' | while IFS=- read -r first last; do
    [ -z "$first" ] || seq "$first" "${last:-$first}"
done | xargs -P "$(nproc)" -I{} "$campaign" work "$manifest" {} "$folder"
