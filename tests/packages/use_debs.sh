#!/bin/sh
# SPDX-License-Identifier: MIT
# What somebody does on a Debian that has nothing but apt: installs the packages and uses what each
# of them brings. The packages lie beside it, and:
#     sphere.c, CMakeLists.txt   a program of the library's, by pkg-config, static, and by CMake
#     cases, vectors             cases, and the vectors made of them where this was built
#
#     use_debs.sh VERSION PRINTED
set -eux
version=$1
printed=$2
cd "$(dirname "$0")"
documents=/usr/share/doc/surehit
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8

install() {
    began=$(date +%s)
    apt-get -q -y --no-install-recommends install "$@" >install.log 2>&1 ||
        { cat install.log; exit 1; }
    echo "took $(($(date +%s) - began)) s: apt-get install $*"
}

# `set -e` does not see a failure behind a "!".
never() {
    if "$@"; then exit 1; fi
}

# Nobody's library but the package's.
uses_it() {
    ldd "$1" | grep -q 'libsurehit.so.0 => /lib/[a-z0-9_]*-linux-gnu'
}

prints_it() {
    test "$("$1")" = "$printed"
}

# The program alone: no compiler, no header.
install ./surehit_*.deb ./libsurehit0_*.deb
never command -v cc
test "$(surehit --version)" = "surehit $version"
uses_it /usr/bin/surehit
surehit render $documents/examples/mirrors.rt -o mirrors.png --tier textbook --quiet
surehit cases --count 2 --shape cone >cone.cases
surehit answer --tier exact <cone.cases | grep -c '^hit'
surehit judge --tier exact --shape sphere --count 20 --require decisions >/dev/null
never surehit judge --tier textbook --shape sphere --count 20 --require decisions >/dev/null
surehit report -o page.html --json page.json --count 1 --shape plane --regime camera --quiet
for peer in /usr/lib/*/surehit/peers/libpeer-*.so; do
    name=${peer##*/libpeer-}
    grep -q "\"name\": *\"${name%.so}\"" page.json
done
mkdir made
for shape in plane disc sphere cylinder cone box; do
    surehit vectors --cases="cases/$shape.cases" --shape $shape -o made
    cmp "made/$shape.jsonl" "vectors/$shape.jsonl"
done
for page in README.md LICENSE copyright docs/contract.md docs/scene.png; do
    test -s "$documents/$page"
done
test -s /usr/share/doc/libsurehit0/copyright
# Links from page to page lead somewhere.
find $documents -name '*.md' | while read -r page; do
    grep -o '](\([^):]*\.md\)[#)]' "$page" | sed 's/^](//; s/[#)]$//' | while read -r link; do
        test -s "$(dirname "$page")/$link"
    done
done

install bash-completion man-db zsh
surehit help | sed -n 's/^  \([a-z][a-z]*\)  .*/\1/p' >commands
test "$(wc -l <commands)" -ge 10
for name in '' $(sed 's/^/-/' commands); do
    man "surehit$name" | grep -q "^SYNOPSIS"
done
test "$(bash -c '. /usr/share/bash-completion/bash_completion; _completion_loader surehit
    complete -p surehit')" = "complete -F _surehit surehit"
test -s /usr/share/fish/vendor_completions.d/surehit.fish
test "$(zsh -f -c 'autoload -U compinit; compinit -D -u; print $_comps[surehit]')" = _surehit

# The library, for who compiles.
apt-get -q -y purge surehit libsurehit0 >/dev/null
test -z "$(find /usr/lib -name 'libsurehit*')"
install ./libsurehit-dev_*.deb ./libsurehit0_*.deb gcc libc6-dev pkg-config
# shellcheck disable=SC2046
cc sphere.c -o sphere $(pkg-config --cflags --libs surehit)
uses_it ./sphere
prints_it ./sphere
# shellcheck disable=SC2046
cc sphere.c -o static -Wl,-Bstatic $(pkg-config --static --cflags --libs surehit) -Wl,-Bdynamic
never uses_it ./static
prints_it ./static
test -s /usr/share/doc/libsurehit-dev/examples/renderer.c
cc -c /usr/share/doc/libsurehit-dev/examples/renderer.c
install cmake make
cmake -S . -B by_cmake
cmake --build by_cmake
for kind in surehit static; do
    prints_it by_cmake/by_$kind
done
uses_it by_cmake/by_surehit
echo all went well
