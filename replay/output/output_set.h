#pragma once
// The files of a job while they are written. All are first completed under temporary names, then
// all get their names, so a failure leaves every old file as it was.

#include <memory>
#include <string>
#include <vector>

#include "core/canvas/canvas_source.h"
#include "core/simulation/simulation.h"
#include "formats/hdf5/state_dump.h"
#include "formats/io/picture_file.h"
#include "replay/job/control.h"
#include "replay/job/render_job.h"
#include "replay/job/report.h"
#include "replay/job/stopwatch.h"
#include "replay/output/effective.h"
#include "replay/output/input_guard.h"
#include "replay/output/kept_outputs.h"
#include "replay/output/output_plan.h"

namespace pentimento {

/// One moment of a canvas, ready to be shown.
struct Scene {
  const CanvasSource& canvas;
  const ChannelBasis& basis;
  const Model& model;
  const Lighting& lighting;
  const CanvasSource* guide = nullptr;  // that `canvas` follows, if it is a finer one
};

/// Must outlive its OutputSet.
struct OutputSettings {
  const PictureChoice& picture;
  OutputSize size;
  int threads = 1;
  const Control& control;
  std::vector<InputFile> inputs = {};  // which no file may replace
  std::string keep = {};  // the folder where frames of films are kept for keep(); empty: nowhere
};

class OutputSet {
 public:
  OutputSet(const OutputSettings& settings, Stopwatch& watch);
  ~OutputSet();

  /// Shades `scene` once into all pictures among `outputs`, or paints the debug view that is asked
  /// for. Errors: kIo, kUsage (crop, AOVs).
  Result<void> add_pictures(const std::vector<PlannedOutput>& outputs, const Scene& scene,
                            const Origin& origin);
  /// Writes `dump` into all state files among `outputs`.
  Result<void> add_states(const std::vector<PlannedOutput>& outputs, const StateDump& dump,
                          const Origin& origin);
  /// The outputs of a stop are complete: keep() keeps them from now on.
  void stop_done();
  /// Keeps the outputs of all stops that are done in `folder`. Errors: kIo.
  Result<std::vector<KeptOutput>> keep(const std::string& folder);
  /// The outputs are those that keep() returned, with their bytes in `folder`; other ones that
  /// there are go away. Errors: kIo, kBadInput for bytes that are damaged and for a name that is
  /// not `planned`.
  Result<void> recall(const std::vector<KeptOutput>& outputs, const std::string& folder,
                      const std::vector<std::vector<PlannedOutput>>& planned);
  /// Gives all files their names.
  Result<std::vector<WrittenFile>> publish();

 private:
  struct Pending;
  Result<void> open_shader();
  Result<void> create(const PlannedOutput& output, const Scene& scene, const Origin& origin);
  Result<void> create_aovs(const PlannedOutput& output, const Scene& scene, const Origin& origin);
  Result<void> add_pending(Pending pending);
  Result<std::size_t> open_video(const std::string& path);
  Result<Pending> make_video(const std::string& path, std::size_t index,
                             const std::vector<std::uint64_t>& frames);
  /// Shades into the pending files with the indices `shown`.
  Result<void> shade(const Scene& scene, const std::vector<std::size_t>& shown);
  Result<void> paint_debug_view(const Scene& scene, const std::vector<std::size_t>& shown);

  const OutputSettings settings_;
  Stopwatch& watch_;
  std::unique_ptr<Shader> shader_;
  std::vector<Pending> pending_;
  std::size_t done_ = 0;  // of the pending: those of stops that are done
};

/// Size in pixels of the part that is shown: the crop, or the whole picture. (The file of a debug
/// view is larger by its legend.) Errors: kUsage, a crop that does not lie inside the picture.
Result<OutputSize> written_size(const PictureChoice& picture, const OutputSize& whole);

}  // namespace pentimento
