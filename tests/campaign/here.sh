#!/bin/sh
# SPDX-License-Identifier: MIT
# Works off what a manifest's folder lacks, on all cores of this machine, or of those that a file
# names as GNU parallel's --sshloginfile has them: they see all three under the same names.
#   here.sh CAMPAIGN MANIFEST FOLDER [HOSTS]
set -eu
campaign=$1 manifest=$2 folder=$3 hosts=${4-}
mkdir -p "$folder"

each() {
    if [ -z "$hosts" ]; then
        xargs -P "$(nproc)" -I{} "$@"
    else # a piece whose host dies is another one's
        parallel -q --will-cite --sshloginfile "$hosts" --retries 5 --line-buffer "$@"
    fi
}

missing=$(sh "$(dirname "$0")/missing.sh" "$campaign" "$manifest" "$folder")
echo "$missing" | sed '/^$/d' | each "$campaign" work "$manifest" {} "$folder"
