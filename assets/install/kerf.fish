# Completion of kerf for fish: subcommands and options are those that its help names.

function __kerf_subcommands
    kerf --help 2>/dev/null | sed -n '/^Subcommands:/,$s/^  \([a-z]*\)  *\(.*\)/\1\t\2/p'
end

function __kerf_options
    set -l command (commandline -opc)[2]
    string match -qr '^[a-z]+$' -- "$command"; or set command
    kerf $command --help 2>/dev/null | grep -oE -- '--[a-z][a-z0-9-]*' | sort -u
end

complete -c kerf -n __fish_use_subcommand -a '(__kerf_subcommands)'
complete -c kerf -n 'string match -q -- "-*" (commandline -ct)' -a '(__kerf_options)'
complete -c kerf -l align -x -a 'none centre icp'
complete -c kerf -l assist -x -a 'none oxygen'
complete -c kerf -l collider-names -x -a 'unreal godot'
complete -c kerf -l colliders -x -a hull
complete -c kerf -l arena -x -a 'yard depot'
complete -c kerf -l difficulty -x -a 'easy normal hard'
complete -c kerf -l driver -x -a 'bot still'
complete -c kerf -l format -x -a 'obj ply stl off glb gltf 3mf'
complete -c kerf -l material -x -a '(kerf materials 2>/dev/null | string replace -rf \'^ *"name": "(.*)",?$\' \'$1\')'
complete -c kerf -l model -x -a 'geometric thermal'
complete -c kerf -l outlines -x -a 'svg dxf'
complete -c kerf -l pattern -x -a 'volume rays4'
complete -c kerf -l rim -x -a 'faces smooth'
complete -c kerf -l scheme -x -a 'longest-edge one-to-four'
complete -c kerf -l show -x -a '(kerf render --help 2>/dev/null | string replace -rf \'^  --show .*\): \' \'\' | string split ", ")'
complete -c kerf -l subdivide -x -a 'loop sqrt3 midpoint'
complete -c kerf -l unit -x -a 'mm cm m in'
