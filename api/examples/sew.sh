#!/usr/bin/env bash
# Sew and drape the top on the command line, without a service.
# Leaves top.glb and top.report.json in the folder OUT, or beside README.md.
set -euo pipefail
cd "$(dirname "$0")/../.."
seamster=${SEAMSTER:-target/release/seamster}
out=${OUT:-.}

"$seamster" sew static/samples/top.dxf static/samples/top.garment.json \
  -o "$out/top.glb" --report "$out/top.report.json"
