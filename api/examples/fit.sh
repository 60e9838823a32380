#!/usr/bin/env bash
# Sew and drape the skirt, or the top (NAME=top): a DXF and its garment in, a mesh and a report out.
# Leaves NAME.glb, NAME.obj and NAME.report.json in the folder OUT, or beside README.md.
set -euo pipefail
cd "$(dirname "$0")/../.."
base=${BASE:-http://127.0.0.1:8737}
out=${OUT:-.}
name=${NAME:-skirt} # or top

# Waits for the end up to a minute; the same key and request always mean the same fit.
fit=$(curl -fsS -o /dev/null -w '%header{location}' "$base/v1/fits" \
  -H 'Prefer: wait=60' -H "Idempotency-Key: $name-$$-$RANDOM" \
  -F pattern=@static/samples/$name.dxf \
  -F "garment=@static/samples/$name.garment.json;type=application/json")

# Where that was not enough, the events end when the fit does.
curl -fsSN -o /dev/null "$base$fit/events"

curl -fsS "$base$fit"
echo
curl -fsS -o "$out/$name.report.json" "$base$fit/report"
curl -fsS -o "$out/$name.glb" "$base$fit/mesh.glb"
curl -fsS -o "$out/$name.obj" -H 'Accept: model/obj' "$base$fit/mesh"
