# shellcheck shell=bash disable=SC2034
# Sourced by ./demo, ./test and the scripts of .ci/: what the machine must have, and how it gets it.
# Needs bash. Nothing here writes outside apt's own folders.

# Each entry is a Debian package; `command:package` is satisfied by any program of that name on the PATH,
# wherever it comes from.
airlight_build_packages=(cmake:cmake ninja:ninja-build pkg-config:pkg-config libglm-dev)
airlight_gl_packages=(libepoxy-dev libegl-dev libegl1 libegl-mesa0 libgl1-mesa-dri)
airlight_example_packages=("${airlight_gl_packages[@]}" libopenexr-dev libimath-dev libpng-dev libcli11-dev
    libglfw3-dev libimgui-dev)
airlight_test_packages=(doctest-dev nlohmann-json3-dev libclang-14-dev glslangValidator:glslang-tools xvfb-run:xvfb
    xauth:xauth)
airlight_bench_packages=(libbenchmark-dev mesa-vulkan-drivers libvulkan-dev glslang-dev spirv-tools)
airlight_ci_packages=(clang++:clang clang-format-14:clang-format-14 chromium:chromium)

say() {
    printf '%s: %s\n' "${0##*/}" "$*"
}

fail() {
    printf '%s: %s\n' "${0##*/}" "$*" >&2
    exit 1
}

# Print those of the given entries that this machine lacks, as package names.
missing_packages() {
    local entry
    for entry in "$@"; do
        if [[ $entry == *:* ]]; then
            command -v "${entry%%:*}" >/dev/null || printf '%s\n' "${entry#*:}"
        elif [[ $(dpkg-query -W -f='${db:Status-Status}' "$entry" 2>/dev/null) != installed ]]; then
            printf '%s\n' "$entry"
        fi
    done
}

# Install what is missing of the given entries, or say what to install and stop.
need_packages() {
    local entries=("$@")
    # A compiler of any make will do; g++ is installed only where there is none.
    if [[ -z ${CXX:-} ]]; then
        entries+=(g++:g++)
    fi

    if ! command -v dpkg-query >/dev/null; then
        say "this system has no dpkg, so nothing was checked or installed; the Debian packages needed are:" \
            "${entries[*]##*:}"
        return
    fi
    local missing
    mapfile -t missing < <(missing_packages "${entries[@]}" | sort -u)
    if [[ ${#missing[@]} -eq 0 ]]; then
        return
    fi

    if [[ -n ${AIRLIGHT_NO_INSTALL:-} ]]; then
        fail "missing packages: ${missing[*]}"
    fi

    local command=(apt-get install -y --no-install-recommends "${missing[@]}")
    local as_root=()
    if [[ $(id -u) -ne 0 ]]; then
        # Without a terminal sudo cannot ask for a password: then it must not need one.
        if command -v sudo >/dev/null && { [[ -t 0 ]] || sudo -n true 2>/dev/null; }; then
            as_root=(sudo)
        else
            fail "packages are missing and this user cannot install them. As root, run: ${command[*]}"
        fi
    fi
    command -v apt-get >/dev/null || fail "packages are missing and there is no apt-get: ${missing[*]}"

    say "installing: ${missing[*]}"
    local log
    log=$(mktemp)
    # A source that cannot be reached makes update fail; whether the packages come all the same shows next.
    "${as_root[@]}" apt-get update -q >"$log" 2>&1 || true
    if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive "${command[@]}" >>"$log" 2>&1; then
        tail -n 15 "$log" >&2
        rm -f "$log"
        fail "apt-get failed (its last lines are above). Is the network reachable? By hand: ${command[*]}"
    fi
    rm -f "$log"
}

# configure <build folder> <cmake arguments>: quiet unless it fails.
configure() {
    local build=$1 log=$1/configure.log
    shift
    mkdir -p "$build" || fail "cannot create $build"
    say "configuring $build"
    if ! cmake -B "$build" "$@" >"$log" 2>&1; then
        cat "$log" >&2
        fail "configuring failed; what CMake said is above and in $log"
    fi
}

# configure_release <build folder>: everything on, as ./test builds it.
configure_release() {
    configure "$1" --preset release -DAIRLIGHT_WERROR="${AIRLIGHT_WERROR:-OFF}" \
        -DAIRLIGHT_BUILD_TESTS=ON -DAIRLIGHT_BUILD_TOOLS=ON -DAIRLIGHT_BUILD_EXAMPLES=ON \
        -DAIRLIGHT_BUILD_STUDY=ON -DAIRLIGHT_BUILD_BENCH=ON \
        ${CXX:+-DCMAKE_CXX_COMPILER="$CXX"}
}

# build <build folder> [targets]: with the compiler's messages only when it fails.
build() {
    local build=$1 log=$1/build.log
    shift
    say "building ${*:-everything} in $build (log: $log)"
    if ! cmake --build "$build" --parallel "${AIRLIGHT_JOBS:-$(nproc)}" ${1:+--target "$@"} >"$log" 2>&1; then
        grep -vE '^\[[0-9]+/[0-9]+\] ' "$log" | tail -n 80 >&2
        fail "the build failed; its last messages are above, all of them in $log"
    fi
    if grep -q 'warning:' "$log"; then
        grep 'warning:' "$log" | sort -u | head -n 20
    fi
}

# run_quietly <log> <command...>: shows the command's output only when it fails.
run_quietly() {
    local log=$1
    shift
    if ! "$@" >"$log" 2>&1; then
        cat "$log"
        fail "failed: $*"
    fi
}
