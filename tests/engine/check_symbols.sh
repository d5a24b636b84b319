#!/bin/sh
# Fails if an object compiled for a wider instruction set defines a symbol that the linker might take
# for another object's: then a machine without those instructions would run them.
#
#   check_symbols.sh NAMESPACE OBJECT...
#
# Every weak or unique symbol of the objects must carry NAMESPACE (the instruction set's) in its name,
# and every strong one too. A pointer to the personality routine is data alike everywhere.
set -eu
namespace=$1
shift
mangled="${#namespace}$namespace"

symbols=$(nm --defined-only --extern-only "$@")
if ! printf '%s\n' "$symbols" | grep -q "$mangled"; then
  echo "no symbol of the namespace $namespace in $*: is this the right object?" >&2
  exit 1
fi
leaked=$(printf '%s\n' "$symbols" | awk 'NF == 3 { print $2, $3 }' |
         grep -v -e "$mangled" -e ' DW\.ref\.__gxx_personality_v0$' || true)
if [ -n "$leaked" ]; then
  echo "symbols compiled for $namespace that other objects may define too:" >&2
  printf '%s\n' "$leaked" | c++filt >&2
  exit 1
fi
