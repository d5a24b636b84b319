#!/usr/bin/env bash
# Installs what docker/packages.txt lists. Run it as often as you like: what is there is left alone, and when nothing is
# missing it neither needs root nor touches the network.
#
#   docker/install.sh                      everything: build, test, demo, runtime
#   docker/install.sh --build --demo       only what these groups need
#   docker/install.sh --runtime            only what the installed programs need
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

fail() {
  printf 'install.sh: %s\n' "$*" >&2
  exit 1
}

groups=()
for argument in "$@"; do
  case $argument in
    --build | --test | --demo | --runtime) groups+=("${argument#--}") ;;
    -h | --help) sed -n '2,/^set/{/^set/d; s/^# \{0,1\}//; p}' install.sh; exit 0 ;;
    *) fail "unknown argument '$argument'; allowed: --build, --test, --demo, --runtime, --help" ;;
  esac
done
[ ${#groups[@]} -gt 0 ] || groups=(build test demo runtime)

# The packages of the chosen groups: "name  # group, group: reason".
wanted() {
  local name groups_of_line group
  while IFS='#' read -r name groups_of_line; do
    for group in "${groups[@]}"; do
      case ", ${groups_of_line%%:*}," in *" $group,"*) echo "${name%% *}"; break ;; esac
    done
  done < <(grep -v -e '^#' -e '^$' packages.txt)
}

missing=()
for package in $(wanted); do
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "install.sh: everything for ${groups[*]} is installed"
  exit 0
fi

command -v apt-get >/dev/null || fail "needs Debian 12 (apt-get is not here); missing: ${missing[*]}"
codename=$(. /etc/os-release && echo "${VERSION_CODENAME:-unknown}")
[ "$codename" = bookworm ] ||
  echo "install.sh: written for Debian 12 (bookworm), this is '$codename': trying, package names may differ" >&2
[ "$(id -u)" -eq 0 ] || fail "must run as root (sudo $0${*:+ $*}) to install: ${missing[*]}"

echo "install.sh: installing ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
apt=(apt-get -qq -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300)
"${apt[@]}" update ||
  fail "apt-get update failed: is the network there, and does the machine's list of package sources work?"
"${apt[@]}" install --yes --no-install-recommends "${missing[@]}" >/dev/null ||
  fail "apt-get could not install all of: ${missing[*]} (its own message is above)"
echo "install.sh: done"
