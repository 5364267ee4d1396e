#include "replay/commands/validate.h"

#include <memory>
#include <utility>

#include "replay/log/log_files.h"
#include "replay/log/swatch.h"
#include "replay/session/header_files.h"
#include "replay/session/log_plan.h"

namespace pentimento {

namespace {
std::int64_t count_undone(const UndoTable& undo) {
  std::int64_t count = 0;
  for (std::int64_t unit = 0; unit < undo.units(); ++unit) count += undo.played(unit) ? 0 : 1;
  return count;
}
/// A picked colour is its own name.
std::string swatch_of(const log::Header& header, const std::string& name) {
  for (const log::PigmentSpec& spec : header.palette)
    if (spec.name == name) return swatch_hex(spec);
  log::PigmentSpec named;
  named.name = name;
  named.library = true;
  return name.starts_with('#') ? name : swatch_hex(named);
}
}  // namespace

Result<LogFacts> validate_log(const std::string& path, const log::ReaderOptions& reading) {
  Result<std::unique_ptr<log::Reader>> reader = log::Reader::open(path, reading);
  if (!reader) return reader.error();
  return validate_log(path, **reader, reading);
}

Result<LogFacts> validate_log(const std::string& path, log::Reader& reader,
                              const log::ReaderOptions& reading) {
  LogFacts facts;
  facts.header = reader.header();
  LogFiles files(path, reading.allow_outside);
  const Result<BrushTable> brushes = open_header_files(facts.header, files);
  if (!brushes) return brushes.error();
  Result<log::Summary> summary = log::summarize(reader);
  if (!summary) return summary.error();
  facts.summary = std::move(*summary);
  if (Result<void> back = reader.rewind(); !back) return back.error();
  StampBudget budget(facts.header, *brushes, reading.limits);
  Result<LogPlan> plan = plan_log(reader, files, {}, {}, {}, &budget);
  if (!plan) return plan.error();
  facts.undone = count_undone(plan->undo);
  facts.steps = plan->steps;
  for (const Pigment& pigment : plan->palette.pigments()) {
    facts.pigments.push_back(pigment.name);
    facts.swatches.push_back(swatch_of(facts.header, pigment.name));
  }
  facts.files = files.hashes();
  return facts;
}

}  // namespace pentimento
