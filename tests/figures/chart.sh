#!/usr/bin/env bash
# Speed against accuracy on this machine: all tables and figures of `gonio chart`, of which src/chart/README.md shows two.
#
#   tests/figures/chart.sh FOLDER [DATA]
#
# DATA is the measured material of the figures `fits` and `resolution`: a file that `gonio chart --data` reads. Without it, nickel
# of the MERL database from $GONIO_DATA, the folder that holds merl/npf.bin, or what gonio makes up where that is not there.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
bin=$top/build/bin
[ $# -ge 1 ] || { sed -n '2,7s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
out=$1 data=${2:-}
export GONIO_DATA=${GONIO_DATA:-$top/../shared/data}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

if [ -z "$data" ] && [ -r "$GONIO_DATA/merl/npf.bin" ]; then
  data=$folder/nickel.binary
  "$bin/make_merl" "$data" nickel
fi
"$bin/gonio" chart -o "$out" ${data:+--data "$data"}
