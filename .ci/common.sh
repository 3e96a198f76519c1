# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# What ./run and ./test share: messages, locks, and a build folder that is always current and whole.
: "${root:?is set by the command, to the folder of the tree}"

# Debian's own tools go before whatever else PATH holds (a python shim breaks meson), and dpkg needs
# the sbin folders, which a plain `su` leaves out. Only installing, building and testing see this
# PATH; surehit itself runs under the user's.
system_path=/usr/sbin:/usr/bin:/sbin:/bin:$PATH

say() {
    printf '%s: %s\n' "${0##*/}" "$*" >&2
}

fail() {
    say "$@"
    exit 1
}

# quietly LOG COMMAND...: adds the command's output to the file, and shows the file if it fails.
quietly() {
    log=$1
    shift
    env PATH="$system_path" "$@" >>"$log" 2>&1 </dev/null || { cat "$log" >&2; return 1; }
}

# Waits until nobody else holds build/NAME.lock. The lock lasts until `unlock`, or until this shell
# and what it started are gone.
lock() {
    mkdir -p "$root/build" 2>/dev/null || true
    file=$root/build/$1.lock
    if [ ! -w "$root/build" ] || { [ -e "$file" ] && [ ! -w "$file" ]; }; then
        fail "can't write to $root/build; another user may own it"
    fi
    command -v flock >/dev/null || return 0
    exec 9>"$file"
    flock -n 9 || { say "waiting for another call to finish"; flock 9; }
}

unlock() {
    exec 9>&-
}

# What root makes in somebody's tree belongs to the tree's owner, who can then go on without root.
hand_over() {
    [ "$(id -u)" -ne 0 ] ||
        chown -hR --reference="$root" "$root/build" "$root/out" 2>/dev/null || true
}
trap hand_over EXIT

# Says every five seconds how far the ninja is that writes this log, for as long as this shell lives.
say_how_far() {
    while sleep 5 2>/dev/null && kill -0 $$ 2>/dev/null; do
        step=$(tail -n 1 "$1" | sed -n 's,^\[\([0-9]*\)/\([0-9]*\)\].*,\1 of \2,p')
        [ -z "$step" ] || say "built $step"
    done
}

# build NAME TARGET OPTION...: the target in build/NAME, configured with the options, up to date.
# The stamp says what a folder was configured from and is written last. Where it differs (configure
# was interrupted, the tree moved, another compiler, package version or option), the folder is made
# anew.
build() {
    folder=$root/build/$1
    target=$2
    shift 2
    stamp="$root $* ${CC-} ${CFLAGS-} ${CXX-} ${CXXFLAGS-} ${LDFLAGS-} ${installed?}"
    rm -f "$folder.log"
    if [ "$(cat "$folder/stamp" 2>/dev/null)" != "$stamp" ]; then
        say "building $folder"
        rm -rf "$folder" 2>/dev/null || fail "can't remove it; another user may own what is in it"
        quietly "$folder.log" meson setup "$folder" "$root" "$@" || fail "meson setup failed"
        printf '%s\n' "$stamp" >"$folder/stamp"
    fi
    say_how_far "$folder.log" >/dev/null 9>&- &
    watcher=$!
    quietly "$folder.log" ninja -C "$folder" "$target" || fail "the build failed"
    kill "$watcher"
}

# The libraries that engineers use, and in build/gallery what judges them. Needs packages.sh.
build_gallery() {
    install_packages gallery
    lock gallery
    build gallery gallery --buildtype=release
    unlock
    node=$root/reference/peers/libraries/node
    if command -v npm >/dev/null && [ ! -e "$node/node_modules" ]; then
        quietly "$root/build/install.log" npm ci --prefix "$node" ||
            say "libraries of npm are left out"
    fi
}
