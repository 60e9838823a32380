#!/usr/bin/env bash
# Seams that need not be said: what the service would sew, and why; then a fit that leaves its seams to the service.
# Leaves skirt.garment.json, with the seams that were found, in the folder OUT, or beside README.md.
set -euo pipefail
cd "$(dirname "$0")/../.."
base=${BASE:-http://127.0.0.1:8737}
out=${OUT:-.}

pattern=$(curl -fsS -o /dev/null -w '%header{location}' "$base/v1/patterns" \
  -F file=@static/samples/skirt.dxf)
curl -fsS -X POST "$base$pattern/seams/suggest"
echo

fit=$(curl -fsS -o /dev/null -w '%header{location}' "$base/v1/fits" -H 'Prefer: wait=60' \
  -H 'Content-Type: application/json' --data-binary @- <<JSON
{"pattern": "${pattern##*/}", "seams": "suggest", "simulate": {"edge_length_m": 0.025}}
JSON
)
curl -fsSN -o /dev/null "$base$fit/events"
curl -fsS "$base$fit"
echo
curl -fsS -o "$out/skirt.garment.json" "$base$fit/garment"
