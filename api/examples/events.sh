#!/usr/bin/env bash
# Follow a fit: progress as it comes, until the event with its final status.
set -euo pipefail
cd "$(dirname "$0")/../.."
base=${BASE:-http://127.0.0.1:8737}

fit=$(curl -fsS -o /dev/null -w '%header{location}' "$base/v1/fits" \
  -F pattern=@static/samples/skirt.dxf \
  -F 'garment=@static/samples/skirt.garment.json;type=application/json')

# To go on after a broken connection: -H 'Last-Event-ID: <the last id read>'
curl -fsSN "$base$fit/events"
