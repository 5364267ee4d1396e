#include "replay/estimate/memory_estimate.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "core/base/plane_memory.h"
#include "core/base/thread_count.h"
#include "core/shading/light_lock.h"
#include "core/shading/sampling.h"
#include "core/shading/tile_plan.h"
#include "replay/output/output_plan.h"
#include "replay/output/output_set.h"

namespace pentimento {

namespace {
constexpr std::int64_t kMB = 1'000'000;
constexpr std::int64_t kMebibyte = 1 << 20;    // what `M` is in --memory-limit
constexpr std::int64_t kProgramme = 75 * kMB;  // code, libraries
constexpr std::int64_t kSchemePlanes = 24;     // scratch of a scheme and the brush's contact
constexpr std::int64_t kFollowedCell = 150;    // noted of a cell of the guide for the detail canvas
constexpr std::int64_t kMarkedCell = 2;        // of these, where nothing is painted
constexpr std::int64_t kShader = 60 * kMB;     // Mesa and what it compiles
constexpr std::int64_t kShadedCell = 80;       // of a tile: packed, and in Mesa's textures
constexpr std::int64_t kDumpCache = 64 * kMB;  // chunks being compressed
constexpr std::int64_t kDumpRead = 256 * kMB;  // of a detail canvas that goes on, at most
constexpr std::int64_t kLeastDetail = 128 * kMB;  // of a scratch file held: tiles at work

/// Rounded up.
std::int64_t mebibytes(std::int64_t bytes) {
  return (bytes + kMebibyte - 1) / kMebibyte;
}

std::int64_t state_bytes(const LogSession& session) {
  const std::int64_t cells = std::int64_t{session.grid.width} * session.grid.height;
  const std::int64_t planes =
      6 + session.basis.bands() + std::int64_t{session.model.layers} * session.basis.channels();
  return cells * planes * 4;
}

/// Of a painted cell of the guide: what is noted for the detail canvas, and what the guide held
/// there.
std::int64_t followed_cell(const LogSession& session) {
  const std::int64_t wet = 1 + std::int64_t{session.model.layers} * session.basis.channels();
  return kFollowedCell + 4 * wet;
}

/// What `ulimit -v` leaves, counted as a job is: with the programme. No limit: as much as there is.
std::int64_t address_space() {
  rlimit space{};
  if (getrlimit(RLIMIT_AS, &space) != 0 || space.rlim_cur == RLIM_INFINITY)
    return std::numeric_limits<std::int64_t>::max();
  std::int64_t pages = 0;  // that are in use, most of them by libraries
  std::ifstream("/proc/self/statm") >> pages;
  return static_cast<std::int64_t>(space.rlim_cur) - pages * sysconf(_SC_PAGE_SIZE) + kProgramme;
}

std::int64_t machine_memory() {
  const std::int64_t all =
      static_cast<std::int64_t>(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGE_SIZE);
  return std::min(all, address_space());
}

std::int64_t picture_planes(OutputKind kind, const PictureChoice& choice,
                            const ChannelBasis& basis) {
  if (kind == OutputKind::kPng) return 3;
  const auto extra = aov_channels(choice.aovs, basis);
  return 3 + (extra ? static_cast<std::int64_t>(extra->size()) : 0);
}

std::int64_t sample_bytes(OutputKind kind, const PictureChoice& choice) {
  if (kind == OutputKind::kPng) return choice.bit_depth / 8;
  return choice.full_float ? 4 : 2;
}

/// The light lock of a poster: rows of pixels until the rows of cells below them are there, a batch
/// of finished rows, and the guide's light.
std::int64_t light_lock_bytes(const LogSession& session, const OutputSize& size,
                              std::int64_t planes) {
  const int whole = session.size.height;  // `size` may be a crop of it
  if (session.detail == 1 || whole <= session.grid.height) return 0;
  const std::int64_t rows = (LightLock::kReach + 1) * (whole / session.grid.height + 1);
  constexpr std::int64_t kBatchRows = 128;
  return (rows + kBatchRows) * size.width * planes * 4 +
         std::int64_t{session.grid.width} * session.grid.height * 3 * 4;
}

/// What is drawn of a picture, along both axes: its pixels, or the cells, whose light is then
/// averaged.
struct DrawnPicture {
  SampleAxis x, y;
  int columns = 0, rows = 0;  // of the crop
};

DrawnPicture drawn_picture(const LogSession& session, const OutputSize& size) {
  const int width = session.size.width, height = session.size.height;
  const bool is_small = width <= session.grid.width && height <= session.grid.height;
  const int k = is_small ? 1 : session.detail;  // a small picture shows the simulation's own grid
  const int nx = k * session.grid.width, ny = k * session.grid.height;
  if (!averages_cells(nx, ny, width, height)) {
    const int samples = std::max(samples_per_pixel(nx, width), samples_per_pixel(ny, height));
    return {{nx, width, samples}, {ny, height, samples}, size.width, size.height};
  }
  const auto cells = [](int pixels, int of, int along) {
    return static_cast<int>(std::int64_t{pixels} * along / of);
  };
  return {{nx, nx, 1}, {ny, ny, 1}, cells(size.width, width, nx), cells(size.height, height, ny)};
}

/// Shading in tiles: a tile's part of the canvas as it is packed and as textures, its targets, and
/// the strips on their way into files.
std::int64_t shading_bytes(const LogSession& session, const RenderJob& job, const OutputSize& size,
                           std::int64_t planes) {
  const DrawnPicture drawn = drawn_picture(session, size);
  TileDemand demand{drawn.x, drawn.y, {0, drawn.columns}, {0, drawn.rows}, job.picture.tile};
  const auto& aovs = job.picture.aovs;
  const int amounts = std::find(aovs.begin(), aovs.end(), "pigment") == aovs.end()
                          ? 0
                          : (session.basis.channels() + 3) / 4;  // textures of channels
  demand.input_texels = 1 + amounts;
  demand.planes = static_cast<int>(planes);
  const TilePlan tiles = plan_tiles(demand);
  const std::int64_t window =
      std::int64_t{drawn.x.most_cells(tiles.width)} * drawn.y.most_cells(tiles.height);
  const std::int64_t targets = std::int64_t{tiles.width} * tiles.height * 16 * 2;
  const std::int64_t strip = std::int64_t{drawn.columns} * tiles.height * planes;
  // While a strip is written, several threads draw the next.
  const std::int64_t strips = wanted_threads(job.threads) > 1 ? 2 : 1;
  return kShader + window * (kShadedCell + 16 * amounts) + targets + strip * (4 * strips + 3) +
         light_lock_bytes(session, size, planes);
}

/// Cells of the guide that a share of its sleep tiles has, where planes take memory by what is
/// written; else all.
std::int64_t painted_cells(const LogSession& session, double share) {
  const std::int64_t cells = std::int64_t{session.grid.width} * session.grid.height;
  if (!memory_follows_paint(session)) return cells;
  return static_cast<std::int64_t>(static_cast<double>(cells) * share);
}

/// Whether a bare canvas takes memory: all other planes are zeros there.
bool has_relief(const LogSession& session) {
  const log::PaperSpec& paper = session.reader->header().paper;
  return session.start || (paper.texture != "smooth" && paper.relief_m != 0);
}

/// Of the guide's state, what is in memory.
std::int64_t held_state_bytes(const LogSession& session, double reached_share) {
  const std::int64_t cells = std::int64_t{session.grid.width} * session.grid.height;
  const std::int64_t bare = has_relief(session) ? cells * 4 : 0;
  return bare + (state_bytes(session) - bare) / cells * painted_cells(session, reached_share);
}

/// Writing a dump: a copy of the guide and, at detail 1, the file; of a finer canvas, what the
/// follower notes in words for each cell of the guide, twice while these are hashed.
std::int64_t dumping_bytes(const LogSession& session, double reached_share) {
  const std::int64_t state = held_state_bytes(session, reached_share);
  if (session.detail == 1) return 2 * state;
  const std::int64_t cells = std::int64_t{session.grid.width} * session.grid.height;
  const std::int64_t words = 1 + waiting_words(session.detail);
  return state + 2 * cells * words * 4 + kDumpCache;
}

struct Writing {
  std::int64_t memory = 0, disk = 0, pictures = 0;  // `pictures` is a part of `disk`
};

/// What writing one set of outputs takes.
Writing writing_needs(const RenderJob& job, const LogSession& session,
                      const std::vector<PlannedOutput>& outputs, double reached_share) {
  Writing needs;
  const std::int64_t state = state_bytes(session);
  const std::int64_t square = std::int64_t{session.detail} * session.detail;
  const Result<OutputSize> written = written_size(job.picture, session.size);
  const OutputSize size = written ? *written : session.size;
  std::int64_t dumping = 0, shading = 0;
  for (const PlannedOutput& output : outputs) {
    if (output.kind == OutputKind::kState) {
      // At detail 1 the file is built in memory.
      needs.disk += session.detail > 1 ? state * (square + 1) : state;
      dumping = dumping_bytes(session, reached_share);
      continue;
    }
    const std::int64_t planes = picture_planes(output.kind, job.picture, session.basis);
    needs.pictures +=
        std::int64_t{size.width} * size.height * planes * sample_bytes(output.kind, job.picture);
    shading = std::max(shading, shading_bytes(session, job, size, planes));
  }
  // One after the other. Mesa stays, which matters beside a file in memory.
  if (session.detail == 1 && shading > 0 && dumping > 0) dumping += kShader;
  needs.disk += needs.pictures;
  needs.memory = std::max(shading, dumping);
  return needs;
}

/// What the job may do about it, as the end of a sentence.
std::string remedies(const RenderJob& job, const LogSession& session, std::int64_t needed,
                     std::int64_t limit, std::int64_t least) {
  std::string text;
  // More than the machine has would be no help.
  if (needed <= machine_memory()) text += fmt::format(", --memory-limit {}M", mebibytes(needed));
  if (session.detail > 1 && job.scratch.empty() && least <= limit) text += ", --scratch DIR";
  if (session.detail > 1) text += fmt::format(", --detail {}", session.detail / 2);
  if (session.refine == Refine::kDirect) text += ", --refine guided";
  return text.empty() ? "; no option makes it fit" : "; it fits with" + text.substr(1);
}

std::int64_t limit_of(const RenderJob& job) {
  return std::min(job.max_memory.value_or(machine_memory()), address_space());
}

std::int64_t guide_bytes(const LogSession& session, const PaintSurvey& survey) {
  const std::int64_t cells = std::int64_t{session.grid.width} * session.grid.height;
  const std::int64_t painted = painted_cells(session, survey.reached_share);
  const std::int64_t used = painted_cells(session, survey.used_share);
  const std::int64_t fine = state_bytes(session) * session.detail * session.detail;
  const std::int64_t read = session.detail_start ? std::min(kDumpRead, fine) : 0;
  const std::int64_t followed =
      session.detail > 1 ? painted * (followed_cell(session) - kMarkedCell) + cells * kMarkedCell
                         : 0;
  return kProgramme + held_state_bytes(session, survey.reached_share) + used * kSchemePlanes * 4 +
         followed + read;
}

std::int64_t budget_beside(std::int64_t others, const RenderJob& job) {
  return std::max(kLeastDetail, limit_of(job) - others);
}
}  // namespace

bool memory_follows_paint(const LogSession& session) {
  // A limit on addresses counts planes whole.
  return session.model.scheme == SchemeKind::kConservative &&
         PlaneMemory::leaves_out(session.grid.width, session.grid.height) &&
         address_space() == std::numeric_limits<std::int64_t>::max();
}

JobNeeds job_needs(const RenderJob& job, const LogSession& session, const PaintSurvey& survey) {
  JobNeeds needs;
  const auto plan = plan_outputs(job.picture.outputs, job.stops);
  // Nothing is written by a dry run without outputs, which still asks what painting takes.
  const Writing writing =
      plan ? writing_needs(job, session, plan->front(), survey.reached_share) : Writing{};
  const auto points = static_cast<std::int64_t>(std::max<std::size_t>(1, job.stops.size()));
  const std::int64_t others = guide_bytes(session, survey) + writing.memory;
  const std::int64_t detail =
      session.detail > 1 ? static_cast<std::int64_t>(survey.detail_bytes) : 0;
  needs.disk_bytes = points * writing.disk;
  needs.picture_bytes = points * writing.pictures;
  needs.scratch_bytes = job.scratch.empty() ? 0 : detail;
  needs.resident_bytes = budget_beside(others, job);
  needs.memory_bytes =
      others + (job.scratch.empty() ? detail : std::min(detail, needs.resident_bytes));
  return needs;
}

Result<void> check_memory(const RenderJob& job, const LogSession& session,
                          const PaintSurvey& survey) {
  const std::int64_t limit = limit_of(job);
  const std::int64_t needed = job_needs(job, session, survey).memory_bytes;
  if (needed <= limit) return {};
  RenderJob with_scratch = job;
  with_scratch.scratch = "any";
  const std::int64_t least = job_needs(with_scratch, session, survey).memory_bytes;
  const std::int64_t k = session.detail;
  return Error{ErrorCode::kLimit,
               fmt::format("{} x {} cells need about {} MiB of memory, the limit is {} MiB{}",
                           k * session.grid.width, k * session.grid.height, mebibytes(needed),
                           limit / kMebibyte, remedies(job, session, needed, limit, least))};
}

}  // namespace pentimento
