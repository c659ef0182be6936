# Sourced by cmake/demo and cmake/test: packages, then configure and build. Bash, Debian 12.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '\n== %s\n' "$*"; }

fail() {
    printf '\n%s: failed: %s\n' "${0##*/}" "$1" >&2
    printf 'what to do: %s\n' "$2" >&2
    exit 1
}

# Installs the missing packages of cmake/packages.txt, without questions; does nothing if all are installed.
install_packages() {
    local wanted missing=() package as_root=()
    mapfile -t wanted < <(grep -Ev '^ *(#|$)' "$root/cmake/packages.txt")
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        fail "this is not a Debian system" "install the equivalents of: ${wanted[*]}; then run cmake --preset release"
    fi
    for package in "${wanted[@]}"; do
        [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || missing+=("$package")
    done
    if ((${#missing[@]} == 0)); then
        say "packages: all ${#wanted[@]} are installed"
        return
    fi
    say "packages: installing ${missing[*]}"
    if ((EUID != 0)); then
        command -v sudo >/dev/null ||
            fail "installing packages needs root, and there is no sudo" \
                 "as root, run: apt-get update && apt-get install --no-install-recommends ${missing[*]}"
        as_root=(sudo)
    fi
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q update ||
        fail "apt-get update" "check the network and /etc/apt/sources.list (Debian 12, component main), then run this again"
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends \
        -o Dpkg::Use-Pty=0 install "${missing[@]}" ||
        fail "apt-get install" "read the message above; if another apt-get holds the lock, wait for it and run this again"
}

# configure_and_build PRESET [TARGET]...
configure_and_build() {
    local preset=$1
    shift
    say "configure: build/$preset"
    mkdir -p "$root/build"
    # A new folder has everything to compile; a configured one keeps its way. See cmake/UnityBuild.cmake.
    local unity=()
    [[ -f $root/build/$preset/CMakeCache.txt ]] || unity=(-D CMAKE_UNITY_BUILD=ON)
    (cd "$root" && cmake --preset "$preset" "${unity[@]}" >build/configure.log 2>&1) || {
        cat "$root/build/configure.log" >&2
        fail "cmake --preset $preset" "read the message above; if the build folder belongs to another path or compiler, run: rm -r build/$preset"
    }
    say "build: build/$preset (a first build takes some minutes)"
    (cd "$root" && cmake --build --preset "$preset" -j "$(nproc)" ${1:+--target "$@"}) ||
        fail "cmake --build --preset $preset" "read the first error above; after an update of the system: rm -r build/$preset, then run this again"
}

# Draws on lavapipe even if the machine has a GPU, so that pictures are the same everywhere.
use_lavapipe() {
    local manifest
    manifest=$(ls /usr/share/vulkan/icd.d/lvp_icd.*.json 2>/dev/null | head -n 1) || true
    [[ -n $manifest ]] ||
        fail "lavapipe's driver manifest is not in /usr/share/vulkan/icd.d" "apt-get install --reinstall mesa-vulkan-drivers"
    export VK_DRIVER_FILES=$manifest VK_ICD_FILENAMES=$manifest
}
