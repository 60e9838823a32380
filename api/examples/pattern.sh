#!/usr/bin/env bash
# Upload a pattern: panels with corners, edges, notches and grain come back, in metres.
# Leaves skirt.svg, skirt.aama.dxf and skirt_specification.json in the folder OUT, or beside README.md.
set -euo pipefail
cd "$(dirname "$0")/../.."
out=${OUT:-.}
base=${BASE:-http://127.0.0.1:8737}

# As a form. A file whose units are wrong or not stated: add ?units=cm (mm, cm, m, inch).
pattern=$(curl -fsS -o /dev/null -w '%header{location}' "$base/v1/patterns" \
  -F file=@static/samples/skirt.dxf)
curl -fsS "$base$pattern"
echo

# As plain bytes.
curl -fsS -o /dev/null "$base/v1/patterns" \
  -H 'Content-Type: image/vnd.dxf' --data-binary @static/samples/top.dxf

# Drawn, with the numbers of corners and edges that seams name.
curl -fsS -o "$out/skirt.svg" "$base$pattern/drawing.svg"

# As files of other programs: AAMA DXF, and a GarmentCode specification. The header Seamster-Left-Out
# names what a format has no place for.
curl -fsS -o "$out/skirt.aama.dxf" "$base$pattern/pattern.dxf"
curl -fsS -o "$out/skirt_specification.json" "$base$pattern/specification.json"

# What is kept, newest first.
curl -fsS "$base/v1/patterns?limit=10"
echo
