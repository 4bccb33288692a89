# SPDX-License-Identifier: BSD-3-Clause
# Toolchain: for x86-64 Linux with glibc 2.28 or later, by the compiler and libraries that scripts/glibc228.sh made.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(root ${CMAKE_CURRENT_LIST_DIR}/../build-glibc228/root)
set(CMAKE_C_COMPILER ${root}/bin/clang)
set(CMAKE_CXX_COMPILER ${root}/bin/clang++)
set(CMAKE_FIND_ROOT_PATH ${root})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
foreach(kind LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()
set(CMAKE_CROSSCOMPILING_EMULATOR env)  # they run here, too
set(CMAKE_EXE_LINKER_FLAGS_INIT "-L${root}/usr/lib ${root}/usr/lib/libruntime.a")
