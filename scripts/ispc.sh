#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# ispc.sh FOLDER: puts a copy of ispc into FOLDER, which compiles the kernels for many paths side by side.  It comes
# with its libraries from Debian 13, for Debian 12 has none (47 MB; apt checks the signatures).  Nothing is installed:
# FOLDER/ispc is the command, and removing FOLDER removes it.  Where that cannot be had, luxpipe does without.
set -eu
[ "$(uname -m)" = x86_64 ] || exit 0
command -v ispc > /dev/null && exit 0
[ ! -x "$1/ispc" ] || exit 0
folder=$(mkdir -p "$1" && cd "$1" && pwd)

without() { echo "ispc: $1; ptrace will be built without lanes, and slower" >&2; exit 0; }
command -v apt-get > /dev/null && command -v dpkg > /dev/null || without 'no apt-get here'
site=$(apt-get indextargets --format "\$(SITE)" 'Created-By: Packages' 'Origin: Debian' 'Component: main' 2> /dev/null |
    head -n 1)
[ -n "$site" ] || without 'apt knows no archive of Debian'
echo 'ispc: a copy of it is fetched from Debian 13 (47 MB); make SETUP=no does without' >&2

# an apt of its own, which knows that archive alone and thinks that nothing is installed
work=$folder/apt
rm -rf "$work" "$folder/debian"
mkdir -p "$work/lists/partial" "$work/archives/partial" "$folder/debian"
echo "deb $site trixie main" > "$work/sources.list"
: > "$work/status"
cat > "$work/apt.conf" << END
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
{ apt-get update -q && apt-get install -q -y --download-only ispc; } > "$work/log" 2>&1 || without 'no copy of ispc'
for deb in "$work"/archives/*.deb; do dpkg -x "$deb" "$folder/debian"; done
rm -r "$work"

# its own loader and libraries: those of this machine are older
libraries=$folder/debian/usr/lib/x86_64-linux-gnu
cat > "$folder/ispc.new" << END
#!/bin/sh
exec "$libraries/ld-linux-x86-64.so.2" --library-path "$libraries" "$folder/debian/usr/bin/ispc" "\$@"
END
chmod +x "$folder/ispc.new"
mv "$folder/ispc.new" "$folder/ispc"
