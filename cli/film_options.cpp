#include "cli/film_options.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "cli/range.h"
#include "cli/values.h"

namespace pentimento::cli {

void FilmOptions::add_to(CLI::App& app) {
  app.add_option("--frames", frames, "of a film, or of pictures with %d or %04d in the name")
      ->check(in_range(1, 100000))
      ->type_name("N");
  app.add_option("--length", length, "of a film: 20s, 2m; in place of --frames")->type_name("TIME");
  app.add_option("--fps", fps, "frames a second of a film (25)")
      ->check(in_range(1.0, 240.0))
      ->type_name("N");
  app.add_option("--along", along,
                 "along what the frames are spread: painting, without its pauses; events; wall")
      ->check(CLI::IsMember({"painting", "events", "wall"}).description(""))
      ->type_name("painting|events|wall");
  app.add_option("--idle-cut", idle_cut_s,
                 "longer pauses take so many seconds of the painting's time (painting: 0.5)")
      ->check(in_range(0.0, 1e6))
      ->type_name("S");
}

Result<FilmChoice> FilmOptions::choice() const {
  FilmChoice film;
  film.along = along == "events" ? FilmAxis::kEvents
               : along == "wall" ? FilmAxis::kWall
                                 : FilmAxis::kPainting;
  film.frames = frames;
  film.idle_cut_s = idle_cut_s;
  film.frames_per_second = fps.value_or(film.frames_per_second);
  if (length.empty()) return film;
  Result<double> seconds = parse_duration("--length", length);
  if (!seconds) return seconds.error();
  film.length_s = *seconds;
  return film;
}

}  // namespace pentimento::cli
