// Linked into golden_states_sse2 and its siblings: makes the program choose its kernels
// (core/base/kernel.h) as on a processor of PENTIMENTO_X86_LEVEL, 1 to 4, at most.
//
// GCC chooses among the versions of a kernel when the program is loaded, from a table of the
// processor's features that __cpu_indicator_init of its library fills. The linker puts the function
// here in its place (--wrap), which fills the table and then strikes out the higher levels. It runs
// before the C library is ready, so it calls nothing else and reads no environment: the level is a
// constant of the program. glibc's tunables cannot do the same, for GCC's table does not heed them.

extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier): the names are GCC's
extern unsigned __cpu_features2[];
int __real___cpu_indicator_init();
int __wrap___cpu_indicator_init();

int __wrap___cpu_indicator_init() {
  constexpr int kWord = 2;  // of the table, with the levels in its bits 0 (v2) to 2 (v4)
  constexpr unsigned kLevels = 7;
  constexpr unsigned kKept = (1U << (PENTIMENTO_X86_LEVEL - 1)) - 1;
  const int result = __real___cpu_indicator_init();
  __cpu_features2[kWord] &= ~kLevels | kKept;
  return result;
}
// NOLINTEND(bugprone-reserved-identifier)
}
