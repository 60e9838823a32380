#!/usr/bin/env bash
# Sew and drape the skirt on the command line, without a service.
# Leaves skirt.glb, skirt.report.json and skirt.png in the folder OUT, or beside README.md.
set -euo pipefail
cd "$(dirname "$0")/../.."
seamster=${SEAMSTER:-target/release/seamster}
out=${OUT:-.}

"$seamster" sew static/samples/skirt.dxf static/samples/skirt.garment.json \
  -o "$out/skirt.glb" --report "$out/skirt.report.json" --picture "$out/skirt.png"
