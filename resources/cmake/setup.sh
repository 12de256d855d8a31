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

# cannotBuild WHAT HOW: what is missing, what to type, and what needs neither. Fails.
cannotBuild() {
    say "$1."
    say "$2"
    say "The portable folder of Shadescope and its live pages need no packages and no compiler: resources/manual/install.md."
    return 1
}

# Elsewhere than on Debian: what to type, with the names that packages have there as far as they are known.
howToInstall() {
    local manager
    for manager in dnf pacman brew; do
        command -v $manager > /dev/null || continue
        case $manager in
            dnf) echo "Type: sudo dnf install $(packagesOf dnf | paste -sd ' ')" ;;
            pacman) echo "Type: sudo pacman -S --needed $(packagesOf pacman | paste -sd ' ')" ;;
            brew) echo "Type: brew install $(packagesOf brew | paste -sd ' ')" ;;
        esac
        return
    done
    echo "Install a C++20 compiler, CMake 3.25, Ninja and the libraries under [build] of resources/packages.txt, which has their names in Debian"
}

# installPackages SECTION...: those that are not there yet, and of Debian 13 those of SECTION-13 too; the network is needed
# only for them.
installPackages() {
    local wanted missing='' log apt tool release
    if ! command -v apt-get > /dev/null; then
        for tool in c++ cmake ninja; do
            command -v $tool > /dev/null || missing+="${missing:+, }$tool"
        done
        # Which libraries are missing CMake finds out.
        [ -z "$missing" ] || cannotBuild "These programs are missing: $missing" "$(howToInstall)"
        return
    fi
    release=$(. /etc/os-release && echo "${VERSION_ID:-}")
    wanted=$(packagesOf "$@" "${@/%/-$release}")
    missing=$(comm -13 \
        <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' $wanted 2> /dev/null | sed -n 's/^installed //p' | sort -u) \
        - <<< "$wanted" | paste -sd ' ')
    [ -n "$missing" ] || return 0
    if [ "$(id -u)" != 0 ] && ! command -v sudo > /dev/null; then
        cannotBuild "These packages are missing, and there is no sudo to install them with: $missing" \
            "Type as root: apt-get update && apt-get install --no-install-recommends $missing"
        return
    fi
    say "Installing packages: $missing"
    log=$(mktemp)
    # Another installation may hold the lock: wait for it.
    apt="env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=600"
    if ! { asRoot $apt update; asRoot $apt install --no-install-recommends $missing; } > "$log" 2>&1 < /dev/null; then
        cannotBuild "The packages could not be installed; $(whyNotInstalled "$log")" \
            "With a network and the right to install, type: sudo apt-get update && sudo apt-get install --no-install-recommends $missing"
        return
    fi
    rm -f "$log"
}

# whyNotInstalled LOG: the last error in it.
whyNotInstalled() {
    local why
    why=$(sed -n 's/^\(E\|Err\|sudo\): *//p' "$1" | tail -1 | cut -c1-150)
    echo "${why:+"$why "}(all of apt's text: $1)"
}

# configure PRESET
configure() {
    local log="$root/build/$1/configure.log" missing
    if command -v apt-get > /dev/null; then
        logged "$log" cmake --preset "$1"
        return
    fi
    cmake --preset "$1" > "$log" 2>&1 < /dev/null && return
    missing=$(sed -n '/^CMake Error/,$ { s/.*Could NOT find \([A-Za-z0-9_+-]*\).*/\1/p; s/.*provided by "\([^"]*\)".*/\1/p; s/.*No package .\([a-z0-9+-]*\). found.*/\1/p; }' "$log" |
        sort -u | paste -sd ' ')
    cannotBuild "CMake finds no ${missing:-library or compiler that it needs}; its text is in $log" "$(howToInstall)"
}

# build PRESET TARGET...: configures when it has to, then builds what changed since the last time.
build() {
    local folder="$root/build/$1"
    mkdir -p "$folder"
    # One build at a time in a folder.
    exec 9> "$folder/.lock"
    flock 9
    # The build files watch every CMake file, but neither the presets nor on which machine they are.
    local machine
    machine=$(sed -n 's/^\(flags\|Features\)[^:]*//p' /proc/cpuinfo 2> /dev/null | head -1) || true
    if [ "$root/CMakePresets.json" -nt "$folder/.configured" ] || [ "$machine" != "$(cat "$folder/.configured")" ]; then
        say "Configuring, preset $1"
        cd "$root"
        configure "$1" || return
        cd - > /dev/null
        printf '%s\n' "$machine" > "$folder/.configured"
    fi
    if ! NINJA_STATUS='%f of %t: ' ninja -C "$folder" "${@:2}" 2>&1 < /dev/null | followBuild "$folder/build.log"; then
        cat "$folder/build.log" >&2
        say "The build failed. This text is in $folder/build.log."
        return 1
    fi
    exec 9>&-
}

# buildCore: the cores of live pages, into build/web. SHADESCOPE_CORE names one where another system has built them; the other
# is beside it.
buildCore() {
    local core="$root/build/web/shadescope_core.wasm.gz"
    if [ -n "${SHADESCOPE_CORE:-}" ]; then
        mkdir -p "${core%/*}"
        cp "${SHADESCOPE_CORE%/*}"/{shadescope_core*.wasm.gz,acorn.js} "${core%/*}"
    else
        installPackages live
        build web web
    fi
}

# What a step of the program's build from nothing costs on average, in CPU seconds: tests/bench/build_cost measures it.
secondsAStep=5

# followBuild FILE: keeps ninja's lines in FILE. If there is something to build, says how long that takes about, and how
# far it is: on a terminal after each step, else after each tenth of them.
followBuild() {
    local line done total said= tenth=1 began=$SECONDS cores
    cores=$(nproc)
    while IFS= read -r line; do
        printf '%s\n' "$line" >&3
        [[ $line =~ ^([0-9]+)\ of\ ([0-9]+): ]] || continue
        done=${BASH_REMATCH[1]} total=${BASH_REMATCH[2]}
        [ -n "$said" ] || say "Building $total steps: $(minutes $((total * secondsAStep / cores))) on $cores cores"
        said=yes
        if [ -t 2 ]; then
            printf '\rBuilding: %s of %s' "$done" "$total" >&2
        elif [ $((done * 10 / total)) -ge $tenth ] && [ "$done" != "$total" ]; then
            tenth=$((done * 10 / total + 1))
            say "Building: $done of $total, $(minutes $(((SECONDS - began) * (total - done) / done))) left"
        fi
    done 3> "$1"
    if [ -n "$said" ]; then
        if [ -t 2 ]; then printf '\r\033[K' >&2; fi
        say "Built in $((SECONDS - began)) s"
    fi
}

# minutes SECONDS: "about 6 minutes", in words for the user.
minutes() {
    case $((($1 + 30) / 60)) in
        0) echo "less than a minute" ;;
        1) echo "about a minute" ;;
        *) echo "about $((($1 + 30) / 60)) minutes" ;;
    esac
}
