#!/usr/bin/env bash
# The fabrics there are, and one of your own: `default_fabric` and `panels.*.fabric` name it by its id.
set -euo pipefail
base=${BASE:-http://127.0.0.1:8737}

curl -fsS "$base/v1/fabrics"
echo

curl -fsS "$base/v1/fabrics" -H 'Content-Type: application/json' --data-binary @- <<'JSON'
{"name": "Tent canvas", "density_kg_m2": 0.4, "thickness_m": 0.0008,
 "stretch_warp_n_m": 9000, "stretch_weft_n_m": 7000, "shear_n_m": 800,
 "bending_warp_n_m": 1e-4, "bending_weft_n_m": 8e-5,
 "friction": 0.4, "damping_ratio": 0.1, "source": "an example"}
JSON
echo
