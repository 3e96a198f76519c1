# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# The Debian packages that ./run and ./test need, named here and in libraries.txt (reference/peers)
# alone, and how they get in.
# Needs common.sh.
: "${root:?}" "${system_path:?}"

packages_for() {
    echo gcc libc6-dev meson ninja-build pkg-config
    echo libgmp-dev libjansson-dev libmpfr-dev libpng-dev libpopt-dev librandom123-dev zlib1g-dev
    echo g++ libcgal-dev # the report's rows about certain and exact come from CGAL
    [ "$1" = run ] && return
    echo check clang gappa libclang-rt-dev libembree-dev locales python3 valgrind
    echo libbullet-dev libeigen3-dev libglm-dev libimath-dev libode-dev # judged (docs/peers.md)
    [ "$1" = packages ] && echo bash cmake fish gcc-mingw-w64-x86-64-win32 man-db mandoc zsh
    [ "$1" = packages ] && echo build-essential debhelper lintian mmdebstrap
    if [ "$1" = page ]; then
        command -v npm >/dev/null || echo nodejs npm
        echo chromium libclang-rt-14-dev-wasm32 lld node-typescript wasi-libc
    fi
    if [ "$1" = arch ]; then
        echo qemu-user gcc-aarch64-linux-gnu libc6-dev-arm64-cross
        echo gcc-arm-linux-gnueabihf libc6-dev-armhf-cross gcc-i686-linux-gnu libc6-dev-i386-cross
        echo gcc-riscv64-linux-gnu libc6-dev-riscv64-cross gcc-s390x-linux-gnu libc6-dev-s390x-cross
    fi
    [ "$1" = cluster ] && echo munge slurm-wlm libopenmpi-dev openssh-server parallel python3-kubernetes
    [ "$1" = site ] && echo mkdocs mkdocs-material
    [ "$1" = python ] && echo mypy python3-dev python3-numpy python3-pip python3-venv
    [ "$1" = gallery ] || return 0
    sed -n 's/^[a-z][^|]*|[^|]*| *\([a-z0-9.-]*\) .*/\1/p' \
        "$root/reference/peers/libraries/libraries.txt" | sort -u
    command -v npm >/dev/null || echo nodejs npm
    echo patch povray # and what the programs of reference/gallery include beside:
    echo libocct-foundation-dev libocct-modeling-data-dev libocct-visualization-dev vc-dev
}

# sudo counts when it asks for nothing, or when there is a terminal to ask on.
can_be_root() {
    [ "$(id -u)" -eq 0 ] && return
    { command -v sudo && { sudo -n true || true </dev/tty; }; } >/dev/null 2>&1
}

# Sets `missing`, and `installed`: name and version of each of the others.
look_for() {
    missing=
    installed=$(dpkg-query -W -f "\${db:Status-Status} \${Package} \${Version};" "$@" \
        2>/dev/null) || true
    for package; do
        case ";$installed" in
        *";installed $package "*) ;;
        *) missing="$missing $package" ;;
        esac
    done
}

stop_with_advice() {
    say "$1; as root:"
    printf 'apt-get update && apt-get install --no-install-recommends%s\n' "$missing" >&2
    exit 1
}

# A fresh machine updates itself at its first start, so both of apt's locks may be taken: apt can
# wait for one, the other takes new tries. An update that fails for good need not matter (the broken
# source may be somebody else's): what counts is whether the packages can be installed.
install_missing() {
    sudo=
    [ "$(id -u)" -eq 0 ] || sudo=sudo
    : >"$root/build/install.log"
    # shellcheck disable=SC2016,SC2086
    quietly "$root/build/install.log" \
        $sudo env PATH="$system_path" DEBIAN_FRONTEND=noninteractive sh -c '
            for pause in 5 15 40; do apt-get -q update && break; sleep "$pause"; done
            exec apt-get -q -y -o DPkg::Lock::Timeout=600 install --no-install-recommends "$@"
        ' install $missing || stop_with_advice "these packages could not be installed"
}

install_with_apt() {
    look_for "$@"
    [ -n "$missing" ] || return 0
    can_be_root || stop_with_advice "packages are missing, and this user may not install them"
    lock install
    look_for "$@"
    if [ -n "$missing" ]; then
        say "installing$missing"
        install_missing
        look_for "$@"
    fi
    unlock
}

# Without apt the libraries are left to meson, which names the first that it can't find.
check_tools() {
    installed=
    for tool in meson ninja cc pkg-config; do
        command -v "$tool" >/dev/null ||
            fail "no $tool, and no apt-get to install it; needed, by their names in Debian: $*"
    done
}

# install_packages run|test|cluster|packages|page|python|site|gallery
install_packages() {
    # shellcheck disable=SC2046
    set -- $(packages_for "$1")
    if command -v dpkg-query >/dev/null && command -v apt-get >/dev/null; then
        install_with_apt "$@"
    else
        check_tools "$@"
    fi
}
