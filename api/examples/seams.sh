#!/usr/bin/env bash
# Check seams before sewing: every fault of every seam at once, and how to mend it.
set -euo pipefail
cd "$(dirname "$0")/../.."
base=${BASE:-http://127.0.0.1:8737}

pattern=$(curl -fsS -o /dev/null -w '%header{location}' "$base/v1/patterns" \
  -F file=@static/samples/skirt.dxf)

# The garment file, or {"seams": [...]} alone.
curl -fsS "$base$pattern/seams/check" \
  -H 'Content-Type: application/json' --data-binary @static/samples/skirt.garment.json
echo

# A corner that the panel does not have is answered with where and what to do.
curl -fsS "$base$pattern/seams/check" -H 'Content-Type: application/json' --data-binary @- <<'JSON'
{"seams": [{"id": "side",
            "a": {"panel": "skirt-front", "from": 1, "to": 2},
            "b": {"panel": "skirt-back", "from": 0, "to": 99}}]}
JSON
echo
