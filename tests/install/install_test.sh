#!/usr/bin/env bash
# Installs a build, moves the installation elsewhere, and lets three other projects use it: one that wants the core alone
# (on a machine that has no gRPC, as far as CMake can see), one that evaluates in its own process and by a server, and one that
# sets no language standard and has headers called like gonio's.
#
#   install_test.sh BUILD_DIR WORK_DIR COMPILER     WORK_DIR is emptied first
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$1 work=$2 compiler=$3
rm -rf "$work"
mkdir -p "$work"
socket_folder=$(mktemp -d) # a socket's path has little room
server=
cleanup() {
  if [ -n "$server" ]; then kill "$server" 2>/dev/null && wait "$server"; fi
  rm -rf "$socket_folder"
}
trap cleanup EXIT

cmake --install "$build" --prefix "$work/first" >"$work/install.log"
mv "$work/first" "$work/prefix" # nothing in it may depend on where it was installed

# One folder, include/gonio, holds all headers of the package, and each stands by itself.
"$here/headers.sh" "$compiler" "$work/prefix/include"

consume() { # NAME CMAKE-ARGUMENT...
  local name=$1
  shift
  cmake -S "$here/$name" -B "$work/$name" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$work/prefix" "$@"
  cmake --build "$work/$name"
}
consume core_consumer -DCMAKE_DISABLE_FIND_PACKAGE_gRPC=ON -DCMAKE_DISABLE_FIND_PACKAGE_Protobuf=ON
"$work/core_consumer/core_consumer"

consume client_consumer
"$work/prefix/bin/goniod" --listen "unix:$socket_folder/socket" 2>"$work/goniod.log" &
server=$!
"$work/client_consumer/client_consumer" "unix:$socket_folder/socket"

consume plain_consumer

"$work/prefix/bin/gonio" --version
# The manual pages and what completes the arguments: one page a command, and the scripts are bash.
share=$work/prefix/share
for page in gonio goniod $(cd "$share/man/man1" && ls gonio-*.1 | sed 's/\.1$//'); do
  head -1 "$share/man/man1/$page.1" | grep -qi "^\.TH $(echo "$page" | sed 's/-/\\\\-/g') 1 "
done
test "$(ls "$share/man/man1" | wc -l)" -ge 15
bash -eu -c 'source "$1/gonio"; source "$1/goniod"
  COMP_WORDS=(gonio render --shape "") COMP_CWORD=3; _gonio; [ "${#COMPREPLY[@]}" = 3 ]
  COMP_WORDS=(goniod --log-f) COMP_CWORD=1; _goniod; [ "${COMPREPLY[*]}" = --log-format ]
' bash "$share/bash-completion/completions"
test -s "$share/fish/vendor_completions.d/gonio.fish" && test -s "$share/zsh/site-functions/_gonio"
test -s "$work/prefix/share/gonio/proto/gonio/v1/service.proto"
if grep -rn -e sanitize -e Werror -e "$build" "$work/prefix/lib" --include '*.cmake'; then
  echo "the lines above leak this build's options or place into the package" >&2
  exit 1
fi
