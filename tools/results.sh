#!/usr/bin/env bash
# Makes the tables of docs/results.md: simulates flights, maps them, judges the maps.
set -euo pipefail

usage() {
    cat <<'END'
usage: tools/results.sh [--jobs N] BUILD DIR [TABLE...]
Simulates the flights of docs/results.md with BUILD/zonegrid, maps them in every way that its tables
compare, judges the maps, and writes each table to DIR/TABLE.md. What is in DIR already is not made again.
Tables: cells faults faults_by_cell fusion navigation screen wires scenes backends, and rates octomap
(these need BUILD/zonegrid-octomap).
  --jobs N    how many maps at a time (default: 2)
Images come at 10 Hz, those of fusion and rates at 30, too. All tables take some hours on two cores.
END
}

jobs=2
if [[ "${1:-}" == --jobs ]]; then
    jobs="${2:-}"
    shift $(($# < 2 ? $# : 2))
fi
if [[ $# -lt 2 || ! "$jobs" =~ ^[1-9][0-9]*$ ]]; then
    usage >&2
    exit 2
fi
build="$1" out="$2"
shift 2
all_tables=(cells faults faults_by_cell fusion navigation screen wires scenes backends rates octomap)
tables=("$@")
[[ $# -gt 0 ]] || tables=("${all_tables[@]}")
for table in "${tables[@]}"; do
    [[ " ${all_tables[*]} " == *" $table "* ]] || {
        echo "results: there is no table $table" >&2
        usage >&2
        exit 2
    }
done
for tool in "$build/zonegrid" jq; do
    command -v "$tool" >/dev/null || {
        echo "results: $tool is missing; build zonegrid, and install jq" >&2
        exit 1
    }
done
case " ${tables[*]} " in
    *" rates "* | *" octomap "*)
        [[ -x "$build/zonegrid-octomap" ]] || {
            echo "results: $build/zonegrid-octomap is missing; configure with -DZONEGRID_OCTOMAP=ON, and build" >&2
            exit 1
        }
        ;;
esac
scenes="$(dirname "${BASH_SOURCE[0]}")/../scenes"
mkdir -p "$out"

# named WORD...: the words as the name of a folder: "slalom --rate 10" is slalom,rate=10.
named() {
    local name="$*"
    name="${name// --/,}"
    echo "${name// /=}"
}

# name_of_map RECORDING MAPPER OPTION...: the name of a map's folder.
name_of_map() {
    echo "$1/$(named "${@:2}")"
}

# simulated SCENE OPTION...: sets `recording` to the name of this flight, which is made unless it is there.
simulated() {
    local scene="$1" options=(--rate "${rate:-10}" "${@:2}")
    recording="$(named "$scene" "${options[@]}")"
    [[ -d "$out/recordings/$recording" ]] || {
        mkdir -p "$out/recordings"
        "$build/zonegrid" simulate "$scenes/$scene.toml" -o "$out/recordings/$recording" --quiet "${options[@]}"
    }
}

# judged RECORDING MAPPER OPTION...: a map of the recording and what it is worth, unless it is there.
# The map's cells are big and no longer needed then.
judged() {
    local recording="$out/recordings/$1" mapper="$2" name map
    name="$(name_of_map "$@")"
    map="$out/maps/$name"
    [[ -f "$out/judged/$name/report.json" ]] && return
    mkdir -p "$out/maps/$1" "$out/judged/$1"
    if [[ $mapper == zonegrid ]]; then
        "$build/zonegrid" map "$recording" -o "$map" --overwrite --history --quiet "${@:3}"
    else
        rm -rf "$map"
        "$build/zonegrid-octomap" "$recording" -o "$map" "${@:3}" >/dev/null
    fi
    "$build/zonegrid" evaluate "$map" --truth "$recording/truth" -o "$out/judged/$name" --overwrite --quiet
    cp "$map/report.json" "$out/judged/$name/"
    rm -r "$map"
}

# A plan is a file with a line a map, in the order of the table: what its row is called, then the recording, the
# mapper and its options. Rows that show the same map share it.
carry_out() {
    local plan="$1"
    export -f judged name_of_map named
    export build out
    # shellcheck disable=SC2016
    cut -d ' ' -f 2- "$plan" | awk '!seen[$0]++' |
        xargs -P "$jobs" -d '\n' -n 1 bash -c 'set -euo pipefail; judged $0'
}

percent='def percent: if . == null then "-" else (. * 1000 | round / 10 | tostring) end;
def metres: if . == null then "-" else (. * 100 | round / 100 | tostring) end;
def mean: map(select(. != null)) | if length == 0 then null else add / length end;
def median: map(select(. != null)) | sort | if length == 0 then null else .[(length / 2) | floor] end;'

# row JUDGED: a line of a table.
row() {
    jq -r "$percent"'
        .cells as $c | [.obstacles.each[] | select(.kind != "ground")] as $each
        | [$c.precision[0].share, $c.precision[1].share, $c.recall[0].share, $c.recall[1].share,
           $c.wrong_free_surface.share, $c.wrong_free_solid.share, $c.wrong_occupied_free.share,
           $c.unknown_free.share | percent]
          + [([$each[] | select(.found)] | length | tostring) + " of " + ($each | length | tostring)]
          + [[$each[] | select(.merged)] | length | tostring]
          + [([$each[].horizontal_error_m] | mean), ([$each[].size_error_m] | mean),
             ([$each[].detection.distance_m] | median) | metres]
        | join(" | ")' "$out/judged/$1/evaluation.json"
}

head_of_rows() {
    echo "| map | precision | within 1 | recall | within 1 | free: surface | solid | occupied: free | unknown | found | merged | aside | size | held from |"
    echo "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"
}
head_of_thin_rows() {
    echo "| map | telephone wire, 10 mm | guys, 20 mm | power wires, 30 mm | poles | lattice mast |"
    echo "|---|---|---|---|---|---|"
}

# thin_row JUDGED: a line of the table of thin obstacles: for each group the median distance from which one is held, the
# share of its cells that are found and that were erased again.
thin_row() {
    jq -r "$percent"'
        def group($names): [.obstacles.each[] | select(.name | test($names))] as $all
            | ([$all[].detection.distance_m] | median | metres) + "; "
              + ([$all[].found_cells | select(. != null)] | ([.[].count] | add) as $n | ([.[].of] | add) as $of
                 | (if ($of // 0) == 0 then null else $n / $of end) | percent) + "; "
              + ([$all[].erased_cells] | ([.[].count] | add) as $n | ([.[].of] | add) as $of
                 | (if ($of // 0) == 0 then null else $n / $of end) | percent);
        [group("^telephone wire"), group("^guy"), group("^power wire"), group("pole"), group("^lattice")]
        | join(" | ")' "$out/judged/$1/evaluation.json"
}

# share_entry JUDGED: precision and recall within one cell, and obstacles found.
share_entry() {
    jq -r "$percent"'
        [.obstacles.each[] | select(.kind != "ground")] as $each
        | [(.cells.precision[1].share, .cells.recall[1].share | percent),
           ([$each[] | select(.found)] | length | tostring)] | join("; ")' "$out/judged/$1/evaluation.json"
}

# digest_entry JUDGED: the first digits of the digests of cells and objects.
digest_entry() {
    jq -r '.digest | "\(.cells[:10]) \(.objects[:10])"' "$out/judged/$1/report.json"
}

# tabulate TABLE ROW: a row for each map of the plan.
tabulate() {
    local table="$1" name map
    {
        "head_of_${2}s"
        while read -r name map; do
            # shellcheck disable=SC2086
            echo "| ${name//_/ } | $("$2" "$(name_of_map $map)") |"
        done <"$out/$table.plan"
    } >"$out/$table.md"
    echo "$out/$table.md"
}

# tabulate_across TABLE ENTRY COLUMN...: a row for all maps that the plan calls by one name, in its order.
tabulate_across() {
    local table="$1" entry="$2" name map
    {
        echo "| map |$(printf ' %s |' "${@:3}")"
        echo "|---|$(printf -- '---|%.0s' "${@:3}")"
        cut -d ' ' -f 1 "$out/$table.plan" | uniq | while read -r name; do
            echo "| ${name//_/ } |$(
                grep "^$name " "$out/$table.plan" | while read -r _ map; do
                    # shellcheck disable=SC2086
                    echo " $("$entry" "$(name_of_map $map)") |"
                done | tr -d '\n'
            )"
        done
    } >"$out/$table.md"
    echo "$out/$table.md"
}

realistic=(--stereo-noise 0.25 --quantise 0.0625 --missing 1 --bleeding 2 --outliers 0.0005 --vibration 0.1)
cell_sizes=(1.0 0.5 0.25 0.1)

# with_faults SCENE none|sensor|all
with_faults() {
    case "$2" in
        none) simulated "$1" ;;
        sensor) simulated "$1" "${realistic[@]}" ;;
        all) simulated "$1" --all-faults ;;
    esac
}

table_cells() {
    local cell model faults
    for cell in "${cell_sizes[@]}"; do
        for model in line span; do
            for faults in none sensor all; do
                with_faults slalom "$faults"
                echo "$cell,$model,$faults $recording zonegrid --cell $cell --model $model"
            done
        done
    done
}

each_fault=("" "--stereo-noise 0.25" "--quantise 0.0625" "--missing 1" "--bleeding 2"
    "--outliers 0.0005" "--missing-sky" "--vibration 0.1" "--navigation-errors 1" "--late-images 0.2"
    "--lost-navigation 0.2" "--all-faults")

# maps_of_each_fault CELL...
maps_of_each_fault() {
    local fault name cell
    for fault in "${each_fault[@]}"; do
        # shellcheck disable=SC2086
        simulated slalom $fault
        name="${fault:-none}"
        name="${name#--}"
        for cell in "$@"; do
            echo "${name// /_} $recording zonegrid --cell $cell --model span"
        done
    done
}

table_faults() { maps_of_each_fault 1.0; }
table_faults_by_cell() { maps_of_each_fault "${cell_sizes[@]}"; }

table_fusion() {
    local limits flight
    for limits in "2 1 2 2" "2 1 4 1" "2 1 4 2" "2 1 8 2" "2 1 32 2" "1 1 4 2" "2 1 4 3" "2 2 4 2"; do
        read -r hit miss limit threshold <<<"$limits"
        for flight in "wires sensor" "slalom all"; do
            # shellcheck disable=SC2086
            rate=30 with_faults $flight
            echo "${limits// /,},${flight/ /-} $recording zonegrid --cell 0.5 --model span --hit $hit --miss $miss --limit $limit --threshold $threshold"
        done
    done
}

# Rays that cross the cells of what has left the image come the more often, the more images there are.
table_rates() {
    local rate
    for rate in 10 30; do
        simulated second_vehicle
        echo "${rate}_Hz,zonegrid $recording zonegrid --cell 1.0 --model span"
        echo "${rate}_Hz,octomap $recording octomap --cell 1.0"
    done
}

table_navigation() {
    local scale cell
    for scale in 0 0.1 0.25 0.5 1; do
        simulated slalom "${realistic[@]}" --navigation-errors "$scale"
        for cell in 1.0 0.5 0.25; do
            echo "$scale,$cell $recording zonegrid --cell $cell --model span"
        done
    done
}

table_screen() {
    local scene
    for scene in slalom field; do
        with_faults "$scene" all
        echo "$scene,all $recording zonegrid --cell 1.0 --model span"
        simulated "$scene" --all-faults --screen 2
        echo "$scene,screen $recording zonegrid --cell 1.0 --model span"
    done
}

# At 0.1 m a map of OctoMap's would take the better part of an hour.
table_octomap() {
    local cell faults model
    for cell in 1.0 0.5 0.25; do
        for faults in none all; do
            with_faults slalom "$faults"
            for model in line span; do
                echo "$cell,$faults,$model $recording zonegrid --cell $cell --model $model"
            done
            echo "$cell,$faults,octomap $recording octomap --cell $cell"
            echo "$cell,$faults,discretized $recording octomap --cell $cell --discretize"
        done
    done
}

table_wires() {
    local cell faults model
    for cell in "${cell_sizes[@]}"; do
        for faults in none sensor; do
            with_faults wires "$faults"
            for model in line span; do
                echo "$cell,$faults,$model $recording zonegrid --cell $cell --model $model"
            done
        done
    done
}

all_scenes=(slalom field empty_field street_canyon tunnel wires forest second_vehicle)

table_scenes() {
    local scene faults
    for scene in "${all_scenes[@]}"; do
        for faults in none all; do
            with_faults "$scene" "$faults"
            echo "$scene,$faults $recording zonegrid --cell 1.0 --model span"
        done
    done
}

backends=(reference opencl vulkan)

table_backends() {
    local scene backend
    for scene in "${all_scenes[@]}"; do
        with_faults "$scene" all
        for backend in "${backends[@]}"; do
            echo "$scene $recording zonegrid --cell 1.0 --model span --backend $backend"
        done
    done
}

for table in "${tables[@]}"; do
    "table_$table" >"$out/$table.plan"
    carry_out "$out/$table.plan" || {
        echo "results: not all maps of the table $table could be made; see above" >&2
        exit 1
    }
    case "$table" in
        backends) tabulate_across "$table" digest_entry "${backends[@]}" ;;
        faults_by_cell) tabulate_across "$table" share_entry "${cell_sizes[@]/%/ m}" ;;
        wires) tabulate "$table" thin_row ;;
        *) tabulate "$table" row ;;
    esac
done
