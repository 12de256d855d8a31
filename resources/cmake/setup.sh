# Sourced by ./run, ./test and .ci/run: installs what is missing, configures, builds.
# Says one line a step on standard error, so that a program's own output stays clean.
# The full text of a step goes to a file, and is shown when the step fails.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
say() { printf '%s\n' "$*" >&2; }

# packagesOf SECTION...: the names in these sections of resources/packages.txt, sorted.
packagesOf() {
    awk -v wanted=" $* " '
        { sub(/#.*/, "") }
        /^\[/ { gsub(/[][ ]/, ""); take = index(wanted, " " $0 " "); next }
        take && NF { print $1 }' "$root/resources/packages.txt" | sort -u
}

asRoot() {
    if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

# logged FILE COMMAND...: runs it with its output in FILE, which is shown when it fails.
logged() {
    local log=$1
    shift
    if ! "$@" > "$log" 2>&1 < /dev/null; then
        cat "$log" >&2
        say "Failed: $*"
        return 1
    fi
}

# installPackages SECTION...: those that are not there yet; the network is needed only for them.
installPackages() {
    local wanted missing log apt
    # Elsewhere than on Debian the packages have other names; CMake says which are missing.
    command -v apt-get > /dev/null || return 0
    wanted=$(packagesOf "$@")
    missing=$(comm -13 \
        <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' $wanted 2> /dev/null | sed -n 's/^installed //p' | sort -u) \
        - <<< "$wanted" | paste -sd ' ')
    [ -n "$missing" ] || return 0
    if [ "$(id -u)" != 0 ] && ! command -v sudo > /dev/null; then
        say "These packages are missing, and there is no sudo to install them with: $missing"
        return 1
    fi
    say "Installing packages: $missing"
    log=$(mktemp)
    # Another installation may hold the lock: wait for it.
    apt="env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=600"
    logged "$log" asRoot $apt update
    logged "$log" asRoot $apt install --no-install-recommends $missing
    rm -f "$log"
}

# build PRESET TARGET: configures when it has to, then builds what changed since the last time.
build() {
    local folder="$root/build/$1"
    mkdir -p "$folder"
    # One build at a time in a folder.
    exec 9> "$folder/.lock"
    flock 9
    # The build files watch every CMake file, but not the presets.
    if [ ! -e "$folder/.configured" ] || [ "$root/CMakePresets.json" -nt "$folder/.configured" ]; then
        say "Configuring, preset $1"
        cd "$root"
        logged "$folder/configure.log" cmake --preset "$1"
        cd - > /dev/null
        touch "$folder/.configured"
    fi
    if ! NINJA_STATUS='%f of %t: ' ninja -C "$folder" "$2" 2>&1 < /dev/null | followBuild "$folder/build.log"; then
        cat "$folder/build.log" >&2
        say "The build failed. This text is in $folder/build.log."
        return 1
    fi
    exec 9>&-
}

# followBuild FILE: keeps ninja's lines in FILE. Says that there is something to build, once, or
# on a terminal how far it is.
followBuild() {
    local line said= began=$SECONDS
    while IFS= read -r line; do
        printf '%s\n' "$line" >&3
        [[ $line =~ ^[0-9]+\ of\ [0-9]+: ]] || continue
        if [ -t 2 ]; then
            printf '\rBuilding: %s' "${line%%:*}" >&2
        elif [ -z "$said" ]; then
            say "Building"
        fi
        said=yes
    done 3> "$1"
    if [ -n "$said" ]; then
        if [ -t 2 ]; then printf '\r\033[K' >&2; fi
        say "Built in $((SECONDS - began)) s"
    fi
}
