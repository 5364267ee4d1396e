#pragma once
// How row kernels are compiled: once per instruction set. The version that fits the processor is
// chosen when the program is loaded. Kernels use only + - * / and selects, and nothing is
// contracted to fused instructions, so every version gives the same bits.

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__OPTIMIZE__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PENTIMENTO_KERNEL \
  __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define PENTIMENTO_KERNEL
#endif

// Stands before a loop and tells the compiler that the iterations are independent of one another,
// whatever the pointers look like. clang finds that out at run time, and warns where its own pragma
// has no effect.
#if defined(__GNUC__) && !defined(__clang__)
#define PENTIMENTO_INDEPENDENT _Pragma("GCC ivdep")
#else
#define PENTIMENTO_INDEPENDENT
#endif
