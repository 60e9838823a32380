#!/usr/bin/env bash
# Make a dress form from measurements, and fetch its mesh. A garment's `avatar` names it by its id.
# Leaves form.glb in the folder given, or in the present one.
set -euo pipefail
out=$(realpath "${1:-.}")
base=${BASE:-http://127.0.0.1:8737}

avatar=$(curl -fsS -o /dev/null -w '%header{location}' "$base/v1/avatars" \
  -H 'Content-Type: application/json' --data-binary @- <<'JSON'
{"form": {"height_m": 1.72, "bust_m": 0.96, "waist_m": 0.78, "hip_m": 1.02}}
JSON
)
curl -fsS "$base$avatar"
echo
curl -fsS -o "$out/form.glb" "$base$avatar/mesh"
