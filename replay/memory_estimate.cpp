#include "replay/memory_estimate.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "replay/output_plan.h"
#include "replay/output_set.h"

namespace pentimento {

namespace {
constexpr std::int64_t kProgramme = 120'000'000;  // code, Mesa, HDF5
constexpr std::int64_t kSchemePlanes = 24;        // scratch of a scheme and the brush's contact
constexpr std::int64_t kPicturePlaneCopies = 3;   // of a strip: shaded, read back, encoding

std::int64_t state_bytes(const LogSession& session) {
  const std::int64_t cells = std::int64_t{session.grid.width} * session.grid.height;
  const std::int64_t planes = 9 + std::int64_t{session.model.layers} * session.basis.channels();
  return cells * planes * 4;
}

std::int64_t machine_memory() {
  return static_cast<std::int64_t>(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGE_SIZE);
}

std::int64_t picture_bytes(OutputKind kind, const PictureChoice& choice, const OutputSize& size,
                           const ChannelBasis& basis) {
  const std::int64_t pixels = std::int64_t{size.width} * size.height;
  if (kind == OutputKind::kPng) return pixels * 3 * (choice.bit_depth / 8);
  const auto extra = aov_channels(choice.aovs, basis);
  const std::int64_t channels = 3 + (extra ? static_cast<std::int64_t>(extra->size()) : 0);
  return pixels * channels * (choice.full_float ? 4 : 2);
}
}  // namespace

JobNeeds job_needs(const RenderJob& job, const LogSession& session) {
  JobNeeds needs;
  const std::int64_t state = state_bytes(session);
  const std::int64_t cells = std::int64_t{session.grid.width} * session.grid.height;
  std::int64_t writing = 0;
  const std::int64_t points =
      std::max<std::int64_t>(1, static_cast<std::int64_t>(job.stops.size()));
  const auto plan = plan_outputs(job.picture.outputs, job.stops);
  if (!plan) return needs;
  const Result<OutputSize> written = written_size(job.picture, session.size);
  const OutputSize size = written ? *written : session.size;
  for (const PlannedOutput& output : plan->front()) {
    if (output.kind == OutputKind::kState) {
      needs.disk_bytes += points * state;
      writing = std::max(writing, 2 * state);  // a copy and the file's image
    } else {
      const std::int64_t bytes = picture_bytes(output.kind, job.picture, size, session.basis);
      needs.disk_bytes += points * bytes;
      const std::int64_t strip = std::int64_t{size.width} * std::min(size.height, job.picture.tile);
      writing = std::max(writing, state + strip * 12 * kPicturePlaneCopies);
    }
  }
  const std::int64_t simulating = kProgramme + state + cells * kSchemePlanes * 4;
  needs.memory_bytes = simulating + writing;
  return needs;
}

Result<void> check_memory(const RenderJob& job, const LogSession& session) {
  const std::int64_t limit = job.max_memory.value_or(machine_memory());
  const std::int64_t needed = job_needs(job, session).memory_bytes;
  if (needed <= limit) return {};
  return Error{
      ErrorCode::kLimit,
      fmt::format("{} x {} cells need about {} MB of memory, more than the limit of {} MB "
                  "(--memory-limit)",
                  session.grid.width, session.grid.height, needed / 1'000'000, limit / 1'000'000)};
}

}  // namespace pentimento
