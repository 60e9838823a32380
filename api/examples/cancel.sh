#!/usr/bin/env bash
# Stop a fit: it is canceled within a second. To stop it again changes nothing.
set -euo pipefail
cd "$(dirname "$0")/../.."
base=${BASE:-http://127.0.0.1:8737}

fit=$(curl -fsS -o /dev/null -w '%header{location}' "$base/v1/fits" \
  -F pattern=@static/samples/skirt.dxf \
  -F 'garment=@static/samples/skirt.garment.json;type=application/json')

curl -fsS -o /dev/null -X DELETE "$base$fit"
curl -fsSN -o /dev/null "$base$fit/events"
curl -fsS "$base$fit"
echo
