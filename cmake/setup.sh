# SPDX-License-Identifier: BSD-3-Clause
# Functions that ./run and ./test share: packages, configuring, building. Sourced by them, with $root set.
# All messages go to standard error, so that standard output contains only the program's output.

program_packages="build-essential cmake ninja-build ccache pkg-config libeigen3-dev liburdfdom-dev libtinyxml2-dev
  libfcl-dev libccd-dev libceres-dev libompl-dev libboost-dev libpng-dev libminizip-dev liblz4-dev libzstd-dev libsqlite3-dev libbullet-dev libmujoco-dev libyaml-cpp-dev libutfcpp-dev nlohmann-json3-dev libcli11-dev libfmt-dev libcurl4-openssl-dev libseccomp-dev"
# Additional packages for `cpack -G DEB`, for a package with the Python module.
deb_packages="pybind11-dev python3-dev python3-numpy dpkg-dev file"
test_packages="$deb_packages patchelf libopenmpi-dev openmpi-bin libgtest-dev libbenchmark-dev libdart-dev libdart-utils-urdf-dev clang-format
  chromium ffmpeg librsvg2-bin
  python3-matplotlib python3-pytest python3-jsonschema python3-yaml python3-pip python3-setuptools python3-wheel mypy"
long_test_packages="clang-tidy clang libclang-rt-14-dev mmdebstrap"

# The viewer is built by node and npm: installed ones are used; Debian's packages are installed if one is missing.
if ! command -v node >/dev/null || ! command -v npm >/dev/null; then
  program_packages="$program_packages nodejs npm"
fi

say() { printf '%s\n' "$*" >&2; }
fail() {
  say "${0##*/}: $1"
  shift
  for line in "$@"; do say "  $line"; done
  exit 1
}

# missing_packages PACKAGE...: the packages that are not installed, on one line.
missing_packages() {
  local package
  for package in "$@"; do
    dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || printf '%s ' "$package"
  done
}

# as_root COMMAND...: runs a command as root, by sudo if necessary.
as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi; }

# ensure_packages PACKAGE...: installs missing packages from the distribution.
ensure_packages() {
  [ -z "${GAITWRIGHT_NO_INSTALL:-}" ] || return 0
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    fail "this system is not Debian or a derivative, so packages cannot be installed automatically." \
      "Install the equivalents of these Debian packages: $*" "Then set GAITWRIGHT_NO_INSTALL=1 and call ${0##*/} again."
  fi
  local missing
  missing=$(missing_packages "$@")
  [ -n "$missing" ] || return 0
  local install="apt-get install -y --no-install-recommends $missing"
  if [ "$(id -u)" != 0 ] && ! command -v sudo >/dev/null; then
    fail "some packages are missing, and only root can install them (sudo is not available)." \
      "As root: apt-get update && $install" "Then call ${0##*/} again."
  fi
  say "Installing from the distribution's packages: $missing"
  as_root apt-get update -qq >&2 || fail "apt-get update failed; is there a network?"
  as_root env DEBIAN_FRONTEND=noninteractive $install -qq >&2 ||
    fail "the packages could not be installed." "By hand: apt-get update && $install"
}

# configure PRESET [-D...]: configures build/PRESET.
configure() {
  local preset=$1 log
  shift
  log=$(mktemp)
  if ! (cd "$root" && cmake --preset "$preset" "$@") >"$log" 2>&1; then
    cat "$log" >&2
    rm -f "$log"
    fail "the build in build/$preset could not be configured; see the output above."
  fi
  rm -f "$log"
}

# build PRESET [TARGET...]
build() {
  local preset=$1
  shift
  local targets=()
  [ $# = 0 ] || targets=(--target "$@")
  say "Building build/$preset (the first time takes minutes)"
  cmake --build "$root/build/$preset" "${targets[@]}" >&2 || fail "the build failed; see the output above."
}
