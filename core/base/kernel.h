#pragma once
// How row kernels are compiled: once per instruction set, chosen when the program is loaded. The
// kernels use only + - * / and selects and nothing is contracted, so every version gives the same
// bits.

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__OPTIMIZE__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PENTIMENTO_KERNEL \
  __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define PENTIMENTO_KERNEL
#endif

// Before a loop: its iterations are independent of one another, whatever the pointers look like.
// clang finds out at run time, and complains where its own pragma does not help.
#if defined(__GNUC__) && !defined(__clang__)
#define PENTIMENTO_INDEPENDENT _Pragma("GCC ivdep")
#else
#define PENTIMENTO_INDEPENDENT
#endif
