# shellcheck shell=bash disable=SC2154
# Sourced by app/run and tests/run, which set `root` to the checkout: installs, configures and builds, so that
# both stand on one build folder. Everything said here, by its tools too, goes to standard error.

# Whoever configures first needs GoogleTest; what else the tests need, tests/run adds. GLFW opens the last line's
# libraries by itself and its package does not ask for them. The panels are written in Roboto.
packages=(cmake ninja-build g++ pkg-config ccache libgl1 libegl1 libgl1-mesa-dri libegl-mesa0 libglfw3-dev
  libimgui-dev libglm-dev nlohmann-json3-dev libepoxy-dev libstb-dev libcli11-dev libbullet-dev libopenal-dev
  libtbb-dev libopenmesh-dev libgtest-dev fonts-roboto-unhinted
  libxrandr2 libxcursor1 libxi6)

say() { printf 'kerf: %s\n' "$*" >&2; }
fail() {
  say "$*"
  exit 1
}

# prepare_release TARGET: in build/, the same for everyone, so that alternating commands configure nothing anew.
prepare_release() {
  local options=(-DCMAKE_BUILD_TYPE=Release)
  [[ ${CI:-} != true ]] || options+=(-DKERF_WARNINGS_AS_ERRORS=ON)
  prepare "$root/build" "$1" "${options[@]}"
}

# prepare FOLDER TARGET CMAKE_OPTION...: ends the script with 1 where it fails. One caller at a time works on a
# folder; the lock ends with the parenthesis, before kerf or ctest runs.
prepare() {
  local folder=$1 target=$2 options=("${@:3}")
  [[ -d $folder ]] || mkdir -p "$folder"
  trap 'exit 130' INT
  (
    trap 'exit 130' INT
    flock -w 2 9 || {
      say "waiting for another build in $folder"
      flock 9
    }
    install_missing
    configure
    compile
  ) 9>"$folder/.lock" </dev/null >&2
  trap - INT
}

install_missing() {
  command -v apt-get >/dev/null || return 0  # not of Debian's family: cmake names what it does not find
  local installed package missing=()
  # shellcheck disable=SC2016  # these are dpkg-query's variables
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null) || true
  for package in "${packages[@]}"; do
    [[ $'\n'$installed$'\n' == *$'\n'"installed $package"$'\n'* ]] || missing+=("$package")
  done
  ((${#missing[@]})) || return 0

  local by_hand="apt-get install --no-install-recommends ${missing[*]}"
  ((EUID == 0)) || command -v sudo >/dev/null || fail "packages are missing and there is no sudo; as root: $by_hand"
  say "installing ${missing[*]}"
  ((EUID == 0)) || sudo true || fail "sudo did not let this user install packages; as root: $by_hand"
  apt_get --simulate install "${missing[@]}" &>/dev/null || update_lists || true
  # Lists that are out of date name files that the mirror no longer has.
  apt_get install "${missing[@]}" || { update_lists && apt_get install "${missing[@]}"; } ||
    fail "could not install ${missing[*]}"
}

# apt waits for another's lock on the packages by itself, but not for one on their lists.
update_lists() {
  local tries=20
  until apt_get update; do
    ((--tries)) || return
    sleep 3
  done
}

# Without the lock's descriptor: a daemon that a package starts would hold the lock for ever.
apt_get() {
  local become=()
  ((EUID == 0)) || become=(sudo)
  "${become[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends \
    -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 "$@" 9>&-
}

# Anew where the folder was configured for another path (a moved checkout), otherwise, by hand, or not to the end, and
# when clang++, which builds the fuzzers, or the libraries that only benchmarks use have come or gone since.
configure() {
  local stamp=$folder/.configured wanted
  wanted="$root ${options[*]} $(command -v clang++ || true) $(ls -d /usr/include/embree3 /usr/include/CGAL 2>/dev/null || true)"
  [[ -f $folder/build.ninja && -f $stamp && $(<"$stamp") == "$wanted" ]] && return
  say "configuring $folder"
  rm -f "$stamp"
  cmake --fresh -S "$root" -B "$folder" -G Ninja "${options[@]}" || fail "could not configure $folder"
  printf '%s\n' "$wanted" >"$stamp"
}

# ccache takes paths below the checkout as relative ones, so a fresh clone finds what another has compiled.
# The filter outlives an interrupt, or ninja would die on the broken pipe before it ends its compilers.
compile() {
  CCACHE_BASEDIR=$root CCACHE_SLOPPINESS=pch_defines,time_macros ninja -C "$folder" "$target" 2>&1 | (
    trap '' INT
    exec sed -u -e '/^ninja: Entering directory/d' -e '/^ninja: no work to do/d' -e '/Re-checking globbed/d'
  ) || fail "could not build $target in $folder"
}
