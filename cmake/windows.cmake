# SPDX-License-Identifier: BSD-3-Clause
# Toolchain: from Debian for Windows (x86-64, 10 of 1903 and later) by mingw-w64, with the libraries that
# scripts/windows.sh built; wine where the build runs a program.  Programs need no DLL but the system's.  A megabyte of
# each stack is there from the start, because ispc's functions do not touch page after page, as Windows wants it.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
set(CMAKE_CROSSCOMPILING_EMULATOR wine)
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -Wl,--no-insert-timestamp -Xlinker --stack -Xlinker 8388608,1048576")
set(CMAKE_FIND_ROOT_PATH ${CMAKE_CURRENT_LIST_DIR}/../build-windows/libraries/usr)
list(APPEND CMAKE_FIND_ROOT_PATH ${CMAKE_FIND_ROOT_PATH}/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
foreach(kind LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()
