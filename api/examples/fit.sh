#!/usr/bin/env bash
# Sew and drape the skirt: a DXF and its garment in, a mesh and a report out.
# Leaves skirt.glb, skirt.obj and skirt.report.json in the folder given, or in the present one.
set -euo pipefail
out=$(realpath "${1:-.}")
cd "$(dirname "$0")/../.."
base=${BASE:-http://127.0.0.1:8737}

# Waits for the end up to a minute; the same key and request always mean the same fit.
fit=$(curl -fsS -o /dev/null -w '%header{location}' "$base/v1/fits" \
  -H 'Prefer: wait=60' -H "Idempotency-Key: skirt-$$-$RANDOM" \
  -F pattern=@static/samples/skirt.dxf \
  -F 'garment=@static/samples/skirt.garment.json;type=application/json')

# Where that was not enough, the events end when the fit does.
curl -fsSN -o /dev/null "$base$fit/events"

curl -fsS "$base$fit"
echo
curl -fsS -o "$out/skirt.report.json" "$base$fit/report"
curl -fsS -o "$out/skirt.glb" "$base$fit/mesh.glb"
curl -fsS -o "$out/skirt.obj" -H 'Accept: model/obj' "$base$fit/mesh"
