// pentimento compare A B: what differs, how much, where.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "cli/command.h"
#include "cli/range.h"
#include "replay/compare/compare.h"

namespace pentimento::cli {

namespace {
constexpr const char* kCompareAbout =
    "Compare two pictures or two state dumps, channel by channel. Exit code 0: equal within what\n"
    "is allowed (nothing, unless a threshold is given); 1: they differ.\n\n"
    "Examples:\n"
    "  pentimento compare before.png after.png --flip 0.02\n"
    "  pentimento compare a.h5 b.h5 --max 1e-6 --json\n"
    "  pentimento compare tablet.h5 poster.h5 --l2 1e-5 --block 1e-3";
}

int run_compare(const Arguments& arguments) {
  std::string a, b;
  CompareThresholds allowed;
  bool json = false;
  int thread_count = 0;
  CLI::App app(kCompareAbout, "pentimento compare");
  app.add_option("a", a, "picture or state dump")->required()->type_name("");
  app.add_option("b", b, "picture or state dump")->required()->type_name("");
  app.add_option("--max", allowed.max, "largest difference allowed in each channel")
      ->check(in_range(0, 1e300))
      ->type_name("N");
  app.add_option("--rms", allowed.rms, "largest RMS difference")
      ->check(in_range(0, 1e300))
      ->type_name("N");
  app.add_option("--psnr", allowed.psnr_db, "smallest PSNR, dB")->type_name("N");
  app.add_option("--differing", allowed.differing, "largest share of differing values, 0..1")
      ->check(in_range(0.0, 1.0))
      ->type_name("N");
  app.add_option("--flip", allowed.flip, "largest mean FLIP of pictures, 0..1")
      ->check(in_range(0.0, 1.0))
      ->type_name("N");
  app.add_option("--l2", allowed.relative_l2,
                 "largest relative L2 difference of what was reduced from a detail canvas")
      ->check(in_range(0.0, 1e300))
      ->type_name("N");
  app.add_option("--block", allowed.worst_block,
                 "largest relative difference of one block of a detail canvas")
      ->check(in_range(0.0, 1e300))
      ->type_name("N");
  app.add_option("--threads", thread_count, "0 = all")->check(in_range(0, 1024))->type_name("N");
  app.add_flag("--json", json, "one JSON object");
  if (const std::optional<int> code = parse(app, arguments)) return *code;
  Result<Comparison> comparison = compare_files(a, b, allowed, thread_count);
  if (!comparison) return fail(comparison.error());
  const int printed =
      print(json ? comparison_json(*comparison) + "\n" : comparison_text(*comparison));
  if (printed != 0) return printed;
  return comparison->equal ? 0 : 1;
}

}  // namespace pentimento::cli
