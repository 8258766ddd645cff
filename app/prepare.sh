# shellcheck shell=bash disable=SC2154
# Sourced by app/run and tests/run, which set `root` to the checkout. Installs, configures and builds in one
# folder for both. All output, including that of tools, goes to standard error.

# Configuring needs GoogleTest; tests/run adds the other packages of the tests. GLFW loads the libraries in the last
# line at run time, without a dependency of its package. Roboto is the font of the panels.
packages=(cmake ninja-build g++ pkg-config ccache libgl1 libegl1 libgl1-mesa-dri libegl-mesa0 libglfw3-dev
  libimgui-dev libglm-dev nlohmann-json3-dev libepoxy-dev libstb-dev libcli11-dev libbullet-dev libopenal-dev
  libtbb-dev libopenmesh-dev lib3mf-dev zlib1g-dev libpugixml-dev libgtest-dev fonts-roboto-unhinted
  libxrandr2 libxcursor1 libxi6)

say() { printf 'kerf: %s\n' "$*" >&2; }
fail() {
  say "$*"
  exit 1
}

# prepare_release TARGET: builds in build/ with the same options for all commands, so none configures again.
prepare_release() {
  local options=(-DCMAKE_BUILD_TYPE=Release)
  [[ ${CI:-} != true ]] || options+=(-DKERF_WARNINGS_AS_ERRORS=ON)
  prepare "$root/build" "$1" "${options[@]}"
}

# prepare FOLDER TARGET CMAKE_OPTION...: builds a target, or ends the script with 1. A lock on the folder admits one
# caller at a time; it ends with the parenthesis, before kerf or ctest runs.
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
  command -v apt-get >/dev/null || return 0  # not a Debian system: cmake reports missing packages
  local installed package missing=()
  # shellcheck disable=SC2016  # these are dpkg-query's variables
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null) || true
  for package in "${packages[@]}"; do
    [[ $'\n'$installed$'\n' == *$'\n'"installed $package"$'\n'* ]] || missing+=("$package")
  done
  ((${#missing[@]})) || return 0

  local by_hand="apt-get install --no-install-recommends ${missing[*]}"
  ((EUID == 0)) || command -v sudo >/dev/null || fail "packages are missing and sudo is not installed; run as root: $by_hand"
  say "installing ${missing[*]}"
  ((EUID == 0)) || sudo true || fail "this user may not install packages with sudo; run as root: $by_hand"
  apt_get --simulate install "${missing[@]}" &>/dev/null || update_lists || true
  # Outdated lists name files that the mirror no longer has.
  apt_get install "${missing[@]}" || { update_lists && apt_get install "${missing[@]}"; } ||
    fail "could not install ${missing[*]}"
}

# apt waits for the lock on the packages, but not for the one on their lists.
update_lists() {
  local tries=20
  until apt_get update; do
    ((--tries)) || return
    sleep 3
  done
}

# Closes the descriptor of the lock, which a daemon started by a package would hold for ever.
apt_get() {
  local become=()
  ((EUID == 0)) || become=(sudo)
  "${become[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends \
    -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 "$@" 9>&-
}

# Configures again if the last run was for another path (a moved checkout), had other options or did not finish, if
# settings were changed by hand, or if clang++ (for the fuzzers), the libraries of the benchmarks or the packages of the
# Python module were installed or removed since.
configure() {
  local stamp=$folder/.configured wanted
  wanted="$root ${options[*]} $(single_option) $(command -v clang++ || true)"
  wanted+=" $(ls -d /usr/include/{embree3,CGAL,pybind11} /usr/include/python3*/Python.h 2>/dev/null || true)"
  [[ -f $folder/build.ninja && -f $stamp && $(<"$stamp") == "$wanted $(settings)" ]] && return
  options+=("$(single_option)")
  say "configuring $folder"
  rm -f "$stamp"
  cmake --fresh -S "$root" -B "$folder" -G Ninja "${options[@]}" || fail "could not configure $folder"
  printf '%s\n' "$wanted $(settings)" >"$stamp"
}

# Prints a checksum of the settings in the cache of cmake.
settings() {
  grep -E '^[^#/].*:(BOOL|STRING|PATH|FILEPATH|UNINITIALIZED)=' "$folder/CMakeCache.txt" 2>/dev/null | cksum
}

# Sources are compiled in groups, or one by one with KERF_SINGLE=1. A folder keeps its mode until KERF_SINGLE is set.
single_option() {
  local single=${KERF_SINGLE:-}
  [[ -n $single ]] || single=$(sed -n 's/^KERF_SINGLE:BOOL=//p' "$folder/CMakeCache.txt" 2>/dev/null) || true
  case $single in
    1 | ON) echo -DKERF_SINGLE=ON ;;
    *) echo -DKERF_SINGLE=OFF ;;
  esac
}

# ccache treats paths below the checkout as relative, so clones share its results, and gets the included headers from
# the compiler.
compile() {
  CCACHE_BASEDIR=$root CCACHE_DEPEND=1 CCACHE_SLOPPINESS=pch_defines,time_macros \
    NINJA_STATUS='[%f/%t %e] ' ninja -C "$folder" "$target" 2>&1 | show_progress ||
    fail "could not build $target in $folder"
}

# show_progress: prints the output of ninja without target names. A terminal gets a progress line; a log gets one after
# 2 seconds and then every 15, so a short build prints nothing. The filter survives an interrupt, because ninja would
# otherwise die on the broken pipe before it ends its compilers.
show_progress() {
  trap '' INT
  local line next_line=2
  while IFS= read -r line; do
    case $line in
      'ninja: Entering directory'* | 'ninja: no work to do'* | *'Re-checking globbed'*) continue ;;
    esac
    if [[ $line =~ ^\[([0-9]+)/([0-9]+)\ ([0-9]+) ]]; then
      show_step "${BASH_REMATCH[@]:1}"
    else
      [[ ! -t 2 ]] || printf '\r\033[K' >&2
      printf '%s\n' "$line" >&2
    fi
  done
  [[ ! -t 2 ]] || printf '\r\033[K' >&2
}

# show_step DONE ALL SECONDS: gives no estimate of the time left, because the steps differ by a factor of a hundred.
show_step() {
  local ended=$1 all=$2 seconds=$3 text bar
  [[ -t 2 ]] || ((seconds >= next_line)) || return 0
  next_line=$((seconds + 15))
  printf -v text 'building, %d of %d steps, %d:%02d' "$ended" "$all" $((seconds / 60)) $((seconds % 60))
  if [[ -t 2 ]]; then
    printf -v bar '%*s' $((30 * ended / all)) ''
    printf '\r\033[K[%-30s] %s' "${bar// /#}" "$text" >&2
  else
    say "$text"
  fi
}
