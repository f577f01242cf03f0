# For 64-bit Arm by Debian's cross compiler: what is linked comes from the folder that tools/arm_root fills, headers that
# are the same for each machine from this one, and programs run under the emulator.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
get_filename_component(arm_root ${CMAKE_CURRENT_LIST_DIR}/../build/arm/root ABSOLUTE)
list(PREPEND CMAKE_PREFIX_PATH ${arm_root}/usr)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64;-L;${arm_root})
