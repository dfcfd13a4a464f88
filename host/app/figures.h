#pragma once
#include "app/morph_film.h"
#include "gpu/device.h"

namespace morphgrid {

struct FiguresOptions {
  std::filesystem::path sheet;  ///< A PNG file.
  FilmOptions film;
  DeviceOptions device;
  bool quiet = false;  ///< No progress.
};

/// What the command reports.
struct FiguresRecord {
  RunRecord run;
  bool morphConverged;
  std::vector<std::filesystem::path> written;  ///< The sheet, if it could be, then the others.
};

/// The panels of a run of the scene on one sheet, with its figures, and what else is asked for.
/// When the device fails on the way, the sheet holds what was drawn before. What turns out not to
/// be writable in the end is in RunRecord::lostFiles. Throws InputError, with nothing written, when
/// a file's name has the wrong extension, the scene cannot be built, a film is asked for where
/// nothing morphs, the sheet would be too large or a file cannot be written there; DeviceError when
/// there is no device that will do.
FiguresRecord makeFigures(Scene scene, const FiguresOptions& options);

/// The same of a finished run, of which nothing is solved again but the way of the morph. Throws
/// InputError also when the state cannot be read.
FiguresRecord makeFigures(const std::filesystem::path& state, const FiguresOptions& options);

}  // namespace morphgrid
