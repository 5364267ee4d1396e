#pragma once
// The detail canvas of a replay: its ground from the log's paper and pictures, its refinement in
// step with the simulation, and itself as what is shaded and dumped.

#include <memory>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/detail/refinement.h"
#include "core/detail/store/detail_source.h"
#include "core/simulation/simulation.h"
#include "formats/log/tables/events.h"
#include "replay/log/log_files.h"
#include "replay/play/fine_ground.h"

namespace pentimento {

/// A finer canvas that was dumped, in the channels of the simulation.
struct FineStart {
  std::shared_ptr<const CanvasSource> canvas;
  DetailNotes notes;
};

struct FineSetup {
  int factor = 1;
  std::string scratch;              // the folder where it lives; empty: in memory
  std::int64_t resident_bytes = 0;  // of a scratch file that stay in memory; 0: all
  std::optional<FineStart> start;   // of that factor; none: made from the simulation's state
};

class FineCanvas {
 public:
  /// Follows `simulation`, which it does not outlive, from its present state on. Errors: those of
  /// the paper's picture, of the scratch folder and of the start's file.
  static Result<std::unique_ptr<FineCanvas>> follow(Simulation& simulation, const FineSetup& setup,
                                                    const log::PaperSpec& paper, LogFiles& files,
                                                    const Threads& threads);
  ~FineCanvas();

  /// The canvas with all that was painted up to now.
  const CanvasSource& source() {
    refinement_.settle();
    return source_;
  }
  /// What that does not tell, to go on from a dump of it.
  DetailNotes notes() {
    refinement_.settle();
    return refinement_.notes();
  }
  const Refinement& refinement() const { return refinement_; }
  /// Why parts of the canvas could not be kept; no error as long as all could.
  const Result<void>& problem() const { return refinement_.canvas().problem(); }
  /// Told of a picture before the simulation loads it.
  FineGround& ground() { return *ground_; }

 private:
  FineCanvas(Simulation& simulation, int factor, std::unique_ptr<FineGround> ground,
             std::unique_ptr<TileStore> store, const Threads& threads);

  Simulation& simulation_;
  std::unique_ptr<FineGround> ground_;
  std::unique_ptr<TileStore> store_;
  Refinement refinement_;
  DetailSource source_;
};

}  // namespace pentimento
