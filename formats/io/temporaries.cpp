#include "formats/io/temporaries.h"

#include <unistd.h>

#include <atomic>
#include <cstring>
#include <string_view>

namespace pentimento {

namespace {
constexpr std::size_t kLongestName = 1024;  // bytes; longer ones are rare, and not noted
constexpr int kPlaces = 128;                // a film with its stills has some dozens open

enum Use : int { kFree, kChanging, kNoted };

struct Place {
  std::atomic<int> use{kFree};
  char name[kLongestName];
};
static_assert(std::atomic<int>::is_always_lock_free);

// A signal handler can only reach a global.
Place places[kPlaces];
}  // namespace

void note_temporary(const std::string& path) {
  if (path.size() >= kLongestName) return;
  for (Place& place : places) {
    int use = kFree;
    if (!place.use.compare_exchange_strong(use, kChanging)) continue;
    std::memcpy(place.name, path.c_str(), path.size() + 1);
    place.use.store(kNoted);
    return;
  }
}

void forget_temporary(const std::string& path) {
  for (Place& place : places) {
    if (place.use.load() != kNoted || std::string_view(place.name) != path) continue;
    place.use.store(kFree);
    return;
  }
}

void remove_temporaries() {
  for (Place& place : places)
    if (place.use.load() == kNoted) ::unlink(place.name);
}

}  // namespace pentimento
