// The kept inputs of the fuzzer: small files of each format, and those that once did harm.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/fuzz/fuzz_target.h"

namespace pentimento::test {
namespace {

TEST(FuzzCorpus, NoKeptInputDoesHarm) {
  const std::filesystem::path corpus = PENTIMENTO_SOURCE_DIR "/tests/fuzz/corpus";
  for (const std::string& target : fuzz_targets()) {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(corpus / target)) {
      std::ifstream file(entry.path(), std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(file), {}};
      SCOPED_TRACE(entry.path().string());
      fuzz(target, bytes);
      // Cut anywhere it does no harm either.
      for (std::size_t part = 0; part < 20; ++part)
        fuzz(target, std::string_view(bytes).substr(0, bytes.size() * part / 20));
      ++files;
    }
    EXPECT_GT(files, 0) << target << " has no kept input";
  }
}

}  // namespace
}  // namespace pentimento::test
