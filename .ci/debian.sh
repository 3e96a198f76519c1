# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# Debian 12 as the host's own apt knows it: its sources, and how they are reached (a proxy, say).

debian_sources() {
    # shellcheck disable=SC2016
    apt-get indextargets --format 'deb $(REPO_URI) $(CODENAME) $(COMPONENT)' \
        'Created-By: Packages' 'Origin: Debian' | sort -u | grep ' bookworm[^ ]* main$'
}

debian_settings() {
    apt-config dump | grep '^Acquire::' || true
}
