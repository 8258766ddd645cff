# Completion of kerf for bash: subcommands and options are those that its help names.

# Prints the values of an option that has a fixed list of them.
_kerf_values() {
  case $1 in
    --align) echo none centre icp ;;
    --arena) echo yard depot ;;
    --assist) echo none oxygen ;;
    --collider-names) echo unreal godot ;;
    --colliders) echo hull ;;
    --difficulty) echo easy normal hard ;;
    --driver) echo bot still ;;
    --format) echo obj ply stl off glb gltf 3mf ;;
    --material) "${COMP_WORDS[0]}" materials 2>/dev/null | sed -n 's/^ *"name": "\(.*\)",*$/\1/p' ;;
    --model) echo geometric thermal ;;
    --outlines) echo svg dxf ;;
    --pattern) echo volume rays4 ;;
    --rim) echo faces smooth ;;
    --scheme) echo longest-edge one-to-four ;;
    --show) "${COMP_WORDS[0]}" render --help 2>/dev/null | sed -n '/^  --show /s/.*): //p' | tr -d , ;;
    --subdivide) echo loop sqrt3 midpoint ;;
    --unit) echo mm cm m in ;;
  esac
}

_kerf() {
  local word=${COMP_WORDS[COMP_CWORD]} command='' words
  ((COMP_CWORD > 1)) && [[ ${COMP_WORDS[1]} =~ ^[a-z]+$ ]] && command=${COMP_WORDS[1]}
  words=$(_kerf_values "${COMP_WORDS[COMP_CWORD - 1]}")
  if [[ -n $words ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  elif [[ $word == -* ]]; then
    words=$("${COMP_WORDS[0]}" ${command:+"$command"} --help 2>/dev/null | grep -oE -- '--[a-z][a-z0-9-]*' | sort -u)
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  elif ((COMP_CWORD == 1)); then
    compopt -o filenames 2>/dev/null  # quotes blanks and continues after folders
    words=$("${COMP_WORDS[0]}" --help 2>/dev/null | sed -n '/^Subcommands:/,$s/^  \([a-z]*\) .*/\1/p')
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word"; compgen -f -- "$word")
  fi
}
complete -o default -F _kerf kerf
