#!/usr/bin/env bash
# Puts what `gonio models --markdown` prints between the markers of src/models/README.md: tests/style/refresh_readme.sh [GONIO]
# GONIO is the built tool, build/bin/gonio if not given.
set -euo pipefail
gonio=$(realpath "${1:-$(dirname "${BASH_SOURCE[0]}")/../../build/bin/gonio}")
cd "$(dirname "${BASH_SOURCE[0]}")/../../src/models"
unset GONIO_SERVER
for marker in begin end; do
  [ "$(grep -c "^<!-- models: $marker" README.md)" = 1 ] ||
    { echo "src/models/README.md must have one line '<!-- models: $marker ... -->'" >&2; exit 1; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$gonio" models --markdown > "$folder/section"
awk -v section="$folder/section" '
  /^<!-- models: end/ { inside = 0 }
  !inside { print }
  /^<!-- models: begin/ {
    print ""
    while ((getline line < section) > 0) print line
    print ""
    inside = 1
  }' README.md > "$folder/readme"
cat "$folder/readme" > README.md
