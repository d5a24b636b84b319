#!/usr/bin/env bash
# Is every C++ file laid out as .clang-format says? `tests/style/format.sh --fix` makes it so.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
mode=(--dry-run --Werror)
[ "${1:-}" = --fix ] && mode=(-i)
find src proto server client tests -type f \( -name '*.h' -o -name '*.cpp' \) -print0 |
  xargs -0 -r clang-format "${mode[@]}"
