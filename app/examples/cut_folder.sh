#!/usr/bin/env bash
# Cuts every mesh of a folder in two with a slot through its middle, on all cores, and collects the reports:
#   cut_folder.sh KERF MESHES OUT
# Skips meshes that have a report, so an interrupted run can be resumed. OUT/failed.txt lists the meshes that
# failed; the next run tries them again. Needs python3.
set -uo pipefail
(($# == 3)) || { echo "usage: cut_folder.sh KERF MESHES OUT" >&2; exit 2; }
kerf=$(command -v "$1") || { echo "cut_folder.sh: there is no program $1" >&2; exit 2; }
kerf=$(realpath "$kerf") meshes=$(realpath "$2") out=$3
mkdir -p "$out"
rm -f "$out/failed.txt"

# Cuts one mesh along its first axis, from above; the path follows from the bounds that `kerf info` prints.
cut_one() {
  local mesh=$1 folder=$2/$(basename "$1") info
  [[ ! -e $folder/report.json ]] || return 0
  info=$("$kerf" info "$mesh") || return
  mkdir -p "$folder"
  python3 -c '
import json, sys
bounds = json.load(sys.stdin)["bounds"]
low, high = bounds["min"], bounds["max"]
size = [h - l for l, h in zip(low, high)]
reach, middle = max(size), [(l + h) / 2 for l, h in zip(low, high)]
keys = [{"t": t, "origin": [middle[0] + s * reach, high[1] + reach, middle[2]], "direction": [0, -1, 0]} for t, s in ((0, -1), (1, 1))]
print(json.dumps({"strokes": [{"laser": {"radius": reach / 200, "range": [0, 4 * reach]}, "keys": keys}]}))
' <<<"$info" >"$folder/path.json" && KERF_THREADS=1 "$kerf" cut "$mesh" --path "$folder/path.json" --out "$folder"
}
try_one() { cut_one "$1" "$2" || { echo "$1" >>"$2/failed.txt"; false; }; }
export -f cut_one try_one
export kerf

# In other locales, a dot matches no name that is not UTF-8.
LC_ALL=C find -L "$meshes" -maxdepth 1 -type f -regextype posix-extended -iregex '.*\.(obj|ply|stl|off|glb|gltf|3mf)' -print0 |
  xargs -0 -r -P "$(nproc)" -I {} bash -c 'try_one "$@"' _ {} "$out"
failed=$?

python3 - "$out" <<'END'
import csv, glob, json, os, sys
with open(os.path.join(sys.argv[1], 'table.csv'), 'w', newline='', errors='surrogateescape') as table:
    rows = csv.writer(table)
    rows.writerow(['mesh', 'faces', 'removed_area', 'pieces', 'cut_ms', 'state_hash'])
    for file in sorted(glob.glob(os.path.join(glob.escape(sys.argv[1]), '*', 'report.json'))):
        with open(file) as text:
            report = json.load(text)
        rows.writerow([os.path.basename(os.path.dirname(file)), report['input']['faces'], report['removed']['area'],
                       len(report['pieces']), report['timing_ms']['cut'], report['state_hash']])
END
exit "$failed"
