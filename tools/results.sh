#!/usr/bin/env bash
# Makes the tables of docs/results.md: simulates flights, maps them, judges the maps.
set -euo pipefail

usage() {
    cat <<'END'
usage: tools/results.sh [--jobs N] BUILD DIR [TABLE...]
Simulates the flights of docs/results.md with BUILD/zonegrid, maps them in every way that its tables
compare, judges the maps, and writes each table to DIR/TABLE.md. What is in DIR already is not made again.
Tables: cells faults fusion navigation screen wires scenes, and rates octomap (these need BUILD/zonegrid-octomap).
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
tables=("$@")
[[ $# -gt 0 ]] || tables=(cells faults fusion navigation screen wires scenes rates octomap)
for tool in "$build/zonegrid" jq; do
    command -v "$tool" >/dev/null || {
        echo "results: $tool is missing; build zonegrid, and install jq" >&2
        exit 1
    }
done
scenes="$(dirname "${BASH_SOURCE[0]}")/../scenes"
mkdir -p "$out"

# simulated NAME SCENE OPTION...: the recording NAME, of $rate or 10 images a second, made unless it is there.
simulated() {
    [[ -d "$out/recordings/$1" ]] || {
        mkdir -p "$out/recordings"
        "$build/zonegrid" simulate "$scenes/$2.toml" -o "$out/recordings/$1" --rate "${rate:-10}" --quiet "${@:3}"
    }
}

# judged NAME RECORDING MAPPER OPTION...: a map of the recording and what it is worth, unless it is there.
# The map's cells are big and no longer needed then.
judged() {
    local name="$1" recording="$out/recordings/$2" mapper="$3" map="$out/maps/$1"
    [[ -f "$out/judged/$name/evaluation.json" ]] && return
    mkdir -p "$out/maps" "$out/judged"
    if [[ $mapper == zonegrid ]]; then
        "$build/zonegrid" map "$recording" -o "$map" --overwrite --history --quiet "${@:4}"
    else
        rm -rf "$map"
        "$build/zonegrid-octomap" "$recording" -o "$map" "${@:4}" >/dev/null
    fi
    "$build/zonegrid" evaluate "$map" --truth "$recording/truth" -o "$out/judged/$name" --overwrite --quiet
    cp "$map/report.json" "$out/judged/$name/"
    rm -r "$map"
}

# A plan is a file with a line a map: NAME, RECORDING, then the mapper and its options. It holds the rows of
# one table in their order; NAME is what the row is called.
carry_out() {
    local plan="$1"
    export -f judged
    export build out
    # shellcheck disable=SC2016
    grep -v '^$' "$plan" | xargs -P "$jobs" -d '\n' -n 1 bash -c 'set -euo pipefail; judged $0'
}

percent='def percent: if . == null then "-" else (. * 1000 | round / 10 | tostring) end;
def metres: if . == null then "-" else (. * 100 | round / 100 | tostring) end;
def mean: map(select(. != null)) | if length == 0 then null else add / length end;
def median: map(select(. != null)) | sort | if length == 0 then null else .[(length / 2) | floor] end;'

# row NAME: a line of a table.
row() {
    jq -r --slurpfile report "$out/judged/$1/report.json" "$percent"'
        .cells as $c | [.obstacles.each[] | select(.kind != "ground")] as $each
        | [$c.precision[0].share, $c.precision[1].share, $c.recall[0].share, $c.recall[1].share,
           $c.wrong_free_surface.share, $c.wrong_free_solid.share, $c.wrong_occupied_free.share,
           $c.unknown_free.share | percent]
          + [([$each[] | select(.found)] | length | tostring) + " of " + ($each | length | tostring)]
          + [[$each[] | select(.merged)] | length | tostring]
          + [([$each[].horizontal_error_m] | mean), ([$each[].size_error_m] | mean),
             ([$each[].detection.distance_m] | median) | metres]
          + [($report[0].time | (.image_ms.map.median // .insert_ms)) | . * 10 | round / 10 | tostring]
        | join(" | ")' "$out/judged/$1/evaluation.json"
}

head_of_rows() {
    echo "| map | precision | within 1 | recall | within 1 | free: surface | solid | occupied: free | unknown | found | merged | aside | size | held from | ms |"
    echo "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"
}
head_of_thin_rows() {
    echo "| map | telephone wire, 10 mm | guys, 20 mm | power wires, 30 mm | poles | lattice mast |"
    echo "|---|---|---|---|---|---|"
}

# thin_row NAME: a line of the table of thin obstacles: for each group the median distance from which one is held, the
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

# tabulate TABLE ROW: the rows of the plan.
tabulate() {
    local table="$1" name
    {
        "head_of_${2}s"
        while read -r name _; do
            [[ -z "$name" ]] || echo "| ${name#"$table"-} | $("$2" "$name") |"
        done <"$out/$table.plan"
    } >"$out/$table.md"
    echo "$out/$table.md"
}

realistic=(--stereo-noise 0.25 --quantise 0.0625 --missing 1 --bleeding 2 --outliers 0.0005 --vibration 0.1)

table_cells() {
    local cell model faults
    simulated slalom-none slalom
    simulated slalom-sensor slalom "${realistic[@]}"
    simulated slalom-all slalom --all-faults
    for cell in 1.0 0.5 0.25 0.1; do
        for model in line span; do
            for faults in none sensor all; do
                echo "cells-$cell,$model,$faults slalom-$faults zonegrid --cell $cell --model $model"
            done
        done
    done
}

table_faults() {
    local number=0 fault name
    local faults=("" "--stereo-noise 0.25" "--quantise 0.0625" "--missing 1" "--bleeding 2"
        "--outliers 0.0005" "--missing-sky" "--vibration 0.1" "--navigation-errors 1" "--late-images 0.2"
        "--lost-navigation 0.2" "--all-faults")
    for fault in "${faults[@]}"; do
        # shellcheck disable=SC2086
        simulated "fault-$number" slalom $fault
        name="${fault:-none}"
        name="${name//--/}"
        echo "faults-${name// /_} fault-$number zonegrid --cell 1.0 --model span"
        number=$((number + 1))
    done
}

table_fusion() {
    local limits flight
    rate=30 simulated slalom-all30 slalom --all-faults
    rate=30 simulated wires-sensor30 wires "${realistic[@]}"
    for limits in "2 1 2 2" "2 1 4 2" "2 1 8 2" "2 1 32 2" "1 1 4 2" "2 1 4 3" "2 2 4 2"; do
        read -r hit miss limit threshold <<<"$limits"
        for flight in wires-sensor30 slalom-all30; do
            echo "fusion-$hit,$miss,$limit,$threshold,${flight%30} $flight zonegrid --cell 0.5 --model span --hit $hit --miss $miss --limit $limit --threshold $threshold"
        done
    done
}

# Rays that cross the cells of what has left the image come the more often, the more images there are.
table_rates() {
    local flight
    simulated second_vehicle-none second_vehicle
    rate=30 simulated second_vehicle-none30 second_vehicle
    for flight in second_vehicle-none second_vehicle-none30; do
        echo "rates-$flight,zonegrid $flight zonegrid --cell 1.0 --model span"
        echo "rates-$flight,octomap $flight octomap --cell 1.0"
    done
}

table_navigation() {
    local scale cell
    for scale in 0 0.1 0.25 0.5 1; do
        simulated "navigation-$scale" slalom "${realistic[@]}" --navigation-errors "$scale"
        for cell in 1.0 0.5 0.25; do
            echo "navigation-$scale,$cell navigation-$scale zonegrid --cell $cell --model span"
        done
    done
}

table_screen() {
    local scene
    for scene in slalom field; do
        simulated "$scene-all" "$scene" --all-faults
        simulated "$scene-screen" "$scene" --all-faults --screen 2
        echo "screen-$scene,all $scene-all zonegrid --cell 1.0 --model span"
        echo "screen-$scene,screen $scene-screen zonegrid --cell 1.0 --model span"
    done
}

table_octomap() {
    local cell faults
    simulated slalom-none slalom
    simulated slalom-all slalom --all-faults
    for cell in 1.0 0.5; do
        for faults in none all; do
            for model in line span; do
                echo "octomap-$cell,$faults,$model slalom-$faults zonegrid --cell $cell --model $model"
            done
            echo "octomap-$cell,$faults,octomap slalom-$faults octomap --cell $cell"
            echo "octomap-$cell,$faults,discretized slalom-$faults octomap --cell $cell --discretize"
        done
    done
}

table_wires() {
    local cell faults
    simulated wires-none wires
    simulated wires-sensor wires "${realistic[@]}"
    for cell in 1.0 0.5 0.25; do
        for faults in none sensor; do
            for model in line span; do
                echo "wires-$cell,$faults,$model wires-$faults zonegrid --cell $cell --model $model"
            done
        done
    done
}

table_scenes() {
    local scene faults
    for scene in slalom field empty_field street_canyon tunnel wires forest second_vehicle; do
        for faults in none all; do
            local options=()
            [[ $faults == none ]] || options=(--all-faults)
            simulated "$scene-$faults" "$scene" "${options[@]}"
            echo "scenes-$scene,$faults $scene-$faults zonegrid --cell 1.0 --model span"
        done
    done
}

for table in "${tables[@]}"; do
    case "$table" in
        cells | faults | fusion | navigation | screen | wires | scenes | rates | octomap) ;;
        *)
            echo "results: there is no table $table" >&2
            usage >&2
            exit 2
            ;;
    esac
    "table_$table" >"$out/$table.plan"
    carry_out "$out/$table.plan"
    if [[ $table == wires ]]; then
        tabulate "$table" thin_row
    else
        tabulate "$table" row
    fi
done
