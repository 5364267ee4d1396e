#pragma once
// Memory that goes back to the system while its owner keeps the addresses.

#include <cstddef>

namespace pentimento {

/// Makes zeros of the whole pages in [begin, begin + bytes), which take no memory until they are
/// written to again. What lies before the first and behind the last of them stays as it is, so it
/// is for memory that holds zeros, or need not hold anything. The memory must be of the process
/// alone, as that of calloc is; where the system cannot take it back, nothing happens.
void give_back(void* begin, std::size_t bytes);

/// Steps of a simulation from one giving back to the next: three seconds of painting. To take a
/// page again costs about as much as to compute its cells once, so a page that is used all the time
/// stays.
inline constexpr int kStepsBetweenGivingBack = 128;

}  // namespace pentimento
