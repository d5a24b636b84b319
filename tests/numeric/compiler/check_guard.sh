#!/bin/sh
# check_guard.sh COMPILE_COMMANDS ROOT FOLDER...: every source in the folders is compiled with the guard against the compiler's
# wrong rounding (CMakeLists.txt at the top), but for kernels: *kernels.cpp, which is said there.
set -eu
commands=$1 root=$2
shift 2
for folder; do
  files=$(awk -v under="$root/$folder/" '
    /"command":/ { guarded = /-fno-tree-slp-vectorize/ }
    /"file":/ { split($0, part, "\""); if (index(part[4], under) == 1 && part[4] !~ /kernels\.cpp$/) print (guarded ? "guarded " : "open ") part[4] }
  ' "$commands")
  [ -n "$files" ] || { echo "no source of $folder in $commands"; exit 1; }
  open=$(echo "$files" | sed -n 's/^open //p')
  [ -z "$open" ] || { printf 'compiled without -fno-tree-slp-vectorize:\n%s\n' "$open"; exit 1; }
done
