#!/usr/bin/env bash
# Error against run time: one garment by two methods to three tolerances, against a reference that the study finds itself.
# Leaves skirt.study.json and skirt.study.svg in the folder OUT, or beside README.md.
set -euo pipefail
cd "$(dirname "$0")/../.."
base=${BASE:-http://127.0.0.1:8737}
out=${OUT:-.}

pattern=$(curl -fsS -o /dev/null -w '%header{location}' "$base/v1/patterns" \
  -F file=@static/samples/skirt.dxf)

study=$(curl -fsS -o /dev/null -w '%header{location}' "$base/v1/studies" \
  -H 'Content-Type: application/json' --data-binary @- <<JSON
{"garment": {"pattern": "${pattern##*/}", "seams": "suggest"},
 "methods": ["newton", "implicit_euler"], "tolerances": [1e-1, 1e-2, 1e-3], "edge_lengths_m": [0.05]}
JSON
)

# The events end when the study does; then it comes with its report.
curl -fsSN -o /dev/null "$base$study/events"
curl -fsS -o "$out/skirt.study.json" "$base$study"
curl -fsS -o "$out/skirt.study.svg" "$base$study/plot.svg"
