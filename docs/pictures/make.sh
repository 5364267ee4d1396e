#!/bin/sh
# Renders the pictures of docs/light.md, docs/cli.md and docs/gallery.md (all but those of the samples).
# usage: docs/pictures/make.sh PENTIMENTO [light|debug|table-2|eight-times]...
# Without names: light and debug, a minute; table-2 takes minutes, eight-times one.
set -eu
command=$(realpath "$1")
shift
pictures=$(realpath "$(dirname "$0")")
samples=$pictures/../../samples
probes=$pictures/../../tests/data/probes
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

run() { "$command" "$@" --quiet; }

light() {
  run render "$samples/impasto/impasto.jsonl" -o "$work/impasto.h5"
  relit() {
    name=$1
    shift
    run relight "$work/impasto.h5" --crop 170,150,300,220 "$@" -o "$pictures/light-$name.png"
  }
  relit lamp
  relit raking --light=1,0.1,0.25
  relit bare --light=1,0.1,0.25 --occlusion 0
  relit studio --environment "$probes/studio.hdr" --lamp dir:-1,1,1,0.2 --varnish 1 --exposure 1.5
  relit probe --environment "$probes/studio.exr" --lamp dir:-1,1,1,0 --exposure 0.7
  relit probe-soft --environment "$probes/studio.exr" --lamp dir:-1,1,1,0 --exposure 0.7 \
    --soft-environment
}

debug() {
  run render "$samples/runs/runs.jsonl" --at 13 -o "$work/runs.h5"
  run relight "$work/runs.h5" --crop 20,120,400,240 -o "$pictures/debug-lit.png"
  for view in height velocity pigment layers wetness; do
    run relight "$work/runs.h5" --debug-view "$view" --crop 20,120,400,240 \
      -o "$pictures/debug-$view.png"
  done
}

table_2() {
  for scale in 0.25 0.5 1; do
    run render "$samples/figure-8/figure-8.jsonl" --width 2048 --sim-scale "$scale" \
      --at mark:stirred --crop 820,540,420,320 -o "$pictures/table-2-$scale.png"
  done
}

eight_times() {
  run render "$samples/mypaint-30s/mypaint-30s.jsonl" --width 8192 --crop 1500,2330,480,384 \
    -o "$pictures/eight-times.png"
}

for name in "${@:-light debug}"; do
  for part in $name; do
    case $part in
      light | debug) "$part" ;;
      table-2) table_2 ;;
      eight-times) eight_times ;;
      *) echo "make.sh: no picture is called $part" >&2; exit 2 ;;
    esac
  done
done
