#!/bin/sh
# Fails if a file under the given folder includes a gRPC or protobuf header, or a log's: the core
# knows nothing of the wire.
set -eu
[ -n "$(find "$1" -name '*.h')" ] || { echo "no header in $1" >&2; exit 1; }
found=$(grep -rnE --include='*.h' --include='*.cpp' --include='*.in' \
        '^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"](grpc|google/|gonio/v1|spdlog|server/|client/|wire/|[^">]*\.pb\.h)' \
        "$1" || true)
if [ -n "$found" ]; then
  echo "the core must not know the wire:" >&2
  printf '%s\n' "$found" >&2
  exit 1
fi
