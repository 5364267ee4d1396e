#pragma once
// The detail canvas of a replay. Its substrate comes from the log's paper and pictures, its
// follower keeps it in step with the simulation, and it is what is shaded and dumped.

#include <memory>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/detail/detail_follower.h"
#include "core/detail/store/detail_source.h"
#include "core/simulation/simulation.h"
#include "formats/log/tables/events.h"
#include "replay/log/log_files.h"
#include "replay/play/replay_substrate.h"

namespace pentimento {

/// A detail canvas from a dump, in the channels of the simulation.
struct DetailStart {
  std::shared_ptr<const CanvasSource> canvas;
  DetailCheckpoint checkpoint;
};

struct ReplayDetailSetup {
  int factor = 1;
  std::string scratch;               // the folder where it lives; empty: in memory
  std::int64_t resident_bytes = 0;   // of a scratch file that stay in memory; 0: all
  std::optional<DetailStart> start;  // of that factor; none: made from the simulation's state
};

class ReplayDetail {
 public:
  /// Follows `simulation` from its present state on. `simulation` must outlive it. Errors: those of
  /// the paper's picture, of the scratch folder and of the start's file.
  static Result<std::unique_ptr<ReplayDetail>> follow(Simulation& simulation,
                                                      const ReplayDetailSetup& setup,
                                                      const log::PaperSpec& paper, LogFiles& files,
                                                      const Threads& threads);
  ~ReplayDetail();

  /// The detail canvas with everything that was painted up to now.
  const CanvasSource& source() {
    follower_.finish_stamps();
    return source_;
  }
  /// All that a dump needs beside source(), to go on from it.
  DetailCheckpoint checkpoint() {
    follower_.finish_stamps();
    return follower_.checkpoint();
  }
  const DetailFollower& follower() const { return follower_; }
  DetailFollower& follower() { return follower_; }
  /// Ok, or the reason why parts of the canvas could not be kept.
  const Result<void>& problem() const { return follower_.canvas().problem(); }
  /// The substrate. It must be told of a picture before the simulation loads the picture.
  ReplaySubstrate& substrate() { return *substrate_; }

 private:
  ReplayDetail(Simulation& simulation, int factor, std::unique_ptr<ReplaySubstrate> substrate,
               std::unique_ptr<TileStore> store, const Threads& threads);

  Simulation& simulation_;
  std::unique_ptr<ReplaySubstrate> substrate_;
  std::unique_ptr<TileStore> store_;
  DetailFollower follower_;
  DetailSource source_;
};

}  // namespace pentimento
