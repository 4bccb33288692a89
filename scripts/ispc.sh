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
echo 'ispc: a copy of it is fetched from Debian 13 (47 MB); make SETUP=no does without' >&2

sh "$(dirname "$0")/apt_copy.sh" "$folder/debian" trixie amd64 ispc || without 'no copy of ispc'

# its own loader and libraries: those of this machine are older
libraries=$folder/debian/usr/lib/x86_64-linux-gnu
cat > "$folder/ispc.new" << END
#!/bin/sh
exec "$libraries/ld-linux-x86-64.so.2" --library-path "$libraries" "$folder/debian/usr/bin/ispc" "\$@"
END
chmod +x "$folder/ispc.new"
mv "$folder/ispc.new" "$folder/ispc"
