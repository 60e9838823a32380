#!/usr/bin/env bash
# A fresh service sews both samples, as the README's quick start does; the result must be valid glTF.
# Usage: tests/smoke.sh [BINARY]
set -euo pipefail
cd "$(dirname "$0")/.."
binary=${1:-target/release/seamster}
folder=$(mktemp -d)
port=$((20000 + RANDOM % 20000))
url=http://127.0.0.1:$port

SEAMSTER_LISTEN=127.0.0.1:$port SEAMSTER_DATA=$folder/data "$binary" serve >"$folder/log" 2>&1 &
server=$!
trap 'kill $server 2>/dev/null; wait $server 2>/dev/null; rm -rf "$folder"' EXIT

fail() {
  echo "smoke: $1" >&2
  tail -20 "$folder/log" >&2
  exit 1
}

for _ in $(seq 100); do
  curl -fsS "$url/health/ready" >/dev/null 2>&1 && break
  kill -0 $server 2>/dev/null || fail "the service stopped"
  sleep 0.1
done
curl -fsS "$url/health/ready" >/dev/null || fail "the service is not ready after 10 s"

for sample in skirt top; do
  echo "smoke: $sample"
  curl -fsS -o /dev/null "$url/v1/patterns" -F "file=@static/samples/$sample.dxf" ||
    fail "the pattern was refused"
  fit=$(curl -sS -o "$folder/answer" -w '%header{location}' "$url/v1/fits" \
    -F "pattern=@static/samples/$sample.dxf" \
    -F "garment=@static/samples/$sample.garment.json;type=application/json")
  [ -n "$fit" ] || fail "the fit was refused: $(cat "$folder/answer")"
  fit=$url$fit
  timeout 600 curl -fsSN "$fit/events" >"$folder/events" || fail "the events broke off"
  curl -fsS "$fit" | grep -q '"status": *"succeeded"' || fail "$(curl -fsS "$fit")"
  curl -fsS -o "$folder/$sample.glb" "$fit/mesh.glb" || fail "there is no mesh"
  node tests/browser/validate-gltf.mjs "$folder/$sample.glb" || fail "the mesh is not valid glTF"
done
echo "smoke: both samples are sewn"
