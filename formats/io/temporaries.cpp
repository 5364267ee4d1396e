#include "formats/io/temporaries.h"

#include <unistd.h>

#include <atomic>
#include <cstring>
#include <string_view>

namespace pentimento {

namespace {
constexpr std::size_t kLongestName = 1024;  // bytes; longer ones are rare, and not noted
constexpr int kNames = 512;                 // each output has two, and a film some dozens of stills

enum Use : int { kFree, kChanging, kNoted };

struct NotedName {
  std::atomic<int> use{kFree};
  char name[kLongestName];
};
static_assert(std::atomic<int>::is_always_lock_free);

// A signal handler can only reach a global.
NotedName names[kNames];
}  // namespace

void note_temporary(const std::string& path) {
  if (path.size() >= kLongestName) return;
  for (NotedName& noted : names) {
    int use = kFree;
    if (!noted.use.compare_exchange_strong(use, kChanging)) continue;
    std::memcpy(noted.name, path.c_str(), path.size() + 1);
    noted.use.store(kNoted);
    return;
  }
}

void forget_temporary(const std::string& path) {
  for (NotedName& noted : names) {
    if (noted.use.load() != kNoted || std::string_view(noted.name) != path) continue;
    noted.use.store(kFree);
    return;
  }
}

void remove_temporaries() {
  for (NotedName& noted : names)
    if (noted.use.load() == kNoted) ::unlink(noted.name);
}

}  // namespace pentimento
