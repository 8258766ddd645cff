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
  wanted="$root ${options[*]} $(single_option) $(command -v clang++ || true)"
  wanted+=" $(ls -d /usr/include/embree3 /usr/include/CGAL 2>/dev/null || true)"
  [[ -f $folder/build.ninja && -f $stamp && $(<"$stamp") == "$wanted" ]] && return
  options+=("$(single_option)")
  say "configuring $folder"
  rm -f "$stamp"
  cmake --fresh -S "$root" -B "$folder" -G Ninja "${options[@]}" || fail "could not configure $folder"
  printf '%s\n' "$wanted" >"$stamp"
}

# Sources are compiled in groups, or each by itself with KERF_SINGLE=1. A folder stays as it is until KERF_SINGLE
# is 0 or 1.
single_option() {
  local single=${KERF_SINGLE:-}
  [[ -n $single ]] || single=$(sed -n 's/^KERF_SINGLE:BOOL=//p' "$folder/CMakeCache.txt" 2>/dev/null) || true
  case $single in
    1 | ON) echo -DKERF_SINGLE=ON ;;
    *) echo -DKERF_SINGLE=OFF ;;
  esac
}

# ccache takes paths below the checkout as relative ones, so a fresh clone finds what another has compiled, and learns
# from the compiler which headers a source includes.
compile() {
  local all_steps all_groups
  all_steps=$(ninja -C "$folder" -t commands "$target" | wc -l)
  all_groups=$(ninja -C "$folder" -t commands "$target" | grep -c '/groups/.* -c ') || true
  CCACHE_BASEDIR=$root CCACHE_DEPEND=1 CCACHE_SLOPPINESS=pch_defines,time_macros \
    NINJA_STATUS='[%f/%t %e] ' ninja -C "$folder" "$target" 2>&1 | show_progress ||
    fail "could not build $target in $folder"
}

# show_progress: what ninja prints, without the names of what it builds. On a terminal a line says how far the build is
# and about how long it still takes; in a log such a line is written after 2 seconds and every 15 from then on, so that
# nothing is said where there is next to nothing to build. The filter outlives an interrupt, or ninja would die on the
# broken pipe before it ends its compilers.
show_progress() {
  trap '' INT
  local line next_line=2 groups=0
  while IFS= read -r line; do
    case $line in
      'ninja: Entering directory'* | 'ninja: no work to do'* | *'Re-checking globbed'*) continue ;;
    esac
    if [[ $line =~ ^\[([0-9]+)/([0-9]+)\ ([0-9]+) ]]; then
      [[ $line != */groups/* ]] || groups=$((groups + 1))
      show_step "${BASH_REMATCH[@]:1}"
    else
      [[ ! -t 2 ]] || printf '\r\033[K' >&2
      printf '%s\n' "$line" >&2
    fi
  done
  [[ ! -t 2 ]] || printf '\r\033[K' >&2
}

# show_step DONE ALL SECONDS: the time left is that of as much work as was done so far, where a group of sources is as
# much as ten other steps. Among the steps of this build there are as many groups, in proportion, as in a build from
# scratch. One step for each processor is under way, and half done.
show_step() {
  local ended=$1 all=$2 seconds=$3 groups_of_all work done text bar left
  [[ -t 2 ]] || ((seconds >= next_line)) || return 0
  next_line=$((seconds + 15))
  text="building, $ended of $all steps"
  if ((ended > 0 && ended < all && seconds >= 5)); then
    groups_of_all=$((all_groups * all / all_steps))
    ((groups_of_all >= groups)) || groups_of_all=$groups
    work=$((2 * all + 18 * groups_of_all))
    done=$((2 * ended + 18 * groups + (groups < groups_of_all ? 10 : 1) * $(nproc)))
    ((done < work)) || done=$((work - 1))
    left=$((seconds * (work - done) / done))
    text+=$(printf ', about %d:%02d left' $((left / 60)) $((left % 60)))
  fi
  if [[ -t 2 ]]; then
    printf -v bar '%*s' $((30 * ended / all)) ''
    printf '\r\033[K[%-30s] %s' "${bar// /#}" "$text" >&2
  else
    say "$text"
  fi
}
