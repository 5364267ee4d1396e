#pragma once
// Which versions of the kernels a program runs.

namespace pentimento {

/// The instruction set of the versions that core/base/kernel.h names and that this program chose
/// when it was loaded: "avx512", "avx2" or "sse2"; "default" where kernels have one version only.
const char* instruction_set();

}  // namespace pentimento
