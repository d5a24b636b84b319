#!/usr/bin/env bash
# Compiles each public header by itself, with nothing but the given folders and the system's to include from.
#
#   headers.sh COMPILER FOLDER...     FOLDER is one that holds gonio/
#
# A header is read twice in a source that has nothing else, so that it must include what it uses and have its own guard.
set -euo pipefail
compiler=$1
shift
includes=()
for folder in "$@"; do
  found=$(cd "$folder" && ls)
  # A name beside gonio/ would be in every user's include space.
  [ "$found" = gonio ] || { echo "$folder holds more or less than gonio/: $found" >&2; exit 1; }
  includes+=(-I "$folder")
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for folder in "$@"; do (cd "$folder" && find gonio -name '*.h'); done | sort >"$work/headers"
[ -s "$work/headers" ] || { echo "no header in $*" >&2; exit 1; }

alone() { # HEADER COMPILER ARGUMENT...
  local header=$1
  shift
  printf '#include <%s>\n#include <%s>\n' "$header" "$header" |
    "$@" -std=c++20 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -fsyntax-only -x c++ - ||
    { echo "not by itself: $header" >&2; return 1; }
}
export -f alone
xargs -P "$(nproc)" -I HEADER bash -c 'alone "$@"' bash HEADER "$compiler" "${includes[@]}" <"$work/headers"
echo "$(wc -l <"$work/headers") headers compile by themselves"
