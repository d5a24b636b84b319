#!/usr/bin/env bash
# Another project adds gonio's folder to its build and gets the core, which needs nothing but threads; with the client it
# also needs gRPC, protobuf and OpenSSL, and nothing of what programs and tests need. The first is built as far as two small
# targets show that includes, standard and libraries are right; the second is configured.
#
#   subdirectory_test.sh SOURCE_DIR WORK_DIR     WORK_DIR is emptied first
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source=$1 work=$2
rm -rf "$work"
mkdir -p "$work"

programs="Eigen3;Ceres;spdlog;CLI11;PNG;OpenEXR;GTest;benchmark"
configure() { # NAME PACKAGES-THAT-ARE-NOT-THERE CMAKE-ARGUMENT...
  local name=$1 missing=$2
  shift 2
  cmake -S "$here/subdirectory_consumer" -B "$work/$name" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DGONIO_SOURCE="$source" -DNOT_THERE="$missing" "$@"
}

configure core "$programs;gRPC;Protobuf;OpenSSL"
cmake --build "$work/core" --target shows evaluates
"$work/core/shows"

configure client "$programs" -DGONIO_BUILD_CLIENT=ON
