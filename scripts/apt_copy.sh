#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# apt_copy.sh FOLDER SUITE ARCH PACKAGE...: unpacks packages of a Debian, and all that they depend on, into FOLDER;
# FOLDER/shlibs says for dpkg-shlibdeps which of them has which library.
# ARCH source: the packages' sources, each patched in a folder of its own; nothing of what they depend on.  ARCH
# upstream: the archives that they were made of.
# Nothing is installed, and this machine's apt learns nothing of it: an apt of its own, which checks the signatures,
# knows that archive alone and thinks that nothing is there.  Status 1, one line on stderr: it cannot be had.
set -eu
folder=$(mkdir -p "$1" && cd "$1" && pwd)
suite=$2 arch=$3
shift 3

without() { echo "apt_copy: $1" >&2; exit 1; }
command -v apt-get > /dev/null && command -v dpkg > /dev/null || without 'no apt-get here'
site=$(apt-get indextargets --format "\$(SITE)" 'Created-By: Packages' 'Origin: Debian' 'Component: main' 2> /dev/null |
    head -n 1)
[ -n "$site" ] || without 'apt knows no archive of Debian'

native=$arch kind=deb fetch='install -y --download-only'
case $arch in
    source) fetch=source ;;
    upstream) fetch='source --tar-only' ;;
esac
[ "${fetch#source}" = "$fetch" ] || native=$(dpkg --print-architecture) kind=deb-src
work=$folder.apt
rm -rf "$work"
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/lists/partial" "$work/archives/partial"
echo "$kind $site $suite main" > "$work/sources.list"
: > "$work/status"
cat > "$work/apt.conf" << END
APT::Architecture "$native";
APT::Architectures { "$native"; };
Dir::Etc::SourceList "$work/sources.list";
Dir::Etc::SourceParts "-";
Dir::State::Lists "$work/lists";
Dir::State::Status "$work/status";
Dir::Cache "$work";
Dir::Cache::Archives "$work/archives";
APT::Install-Recommends "false";
APT::Sandbox::User "";
END
APT_CONFIG=$work/apt.conf
export APT_CONFIG
{ apt-get update -q && cd "$folder" && apt-get -q $fetch "$@"; } > "$work/log" 2>&1 || {
    tail -n 3 "$work/log" >&2
    without "Debian's $suite has no copy for $arch of: $*"
}
for deb in "$work"/archives/*.deb; do
    [ -e "$deb" ] || continue
    dpkg -x "$deb" "$folder"
    dpkg-deb -I "$deb" shlibs >> "$folder/shlibs" 2> /dev/null || :
done
