#include "print/calibration_page.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/read_file.h"
#include "print/assembly_page.h"
#include "print/html_text.h"
#include "print/measurements.h"
#include "print/pending_files.h"

namespace morphgrid {
namespace {

using Eigen::Vector2d;

constexpr const char* kPlateStyle =
    "<style>\nbody { font-family: sans-serif; max-width: 60em; margin: 1em auto; }\n"
    "figure { margin: 1em 0; break-before: page; }\n@page { margin: 5mm; }\n</style>\n";
constexpr double kPlateFrame = 12;  // Around the specimens, mm.
constexpr double kPlateRuler = 50;

/// Millimetres on the map, whose y points down.
class PlateMap {
 public:
  explicit PlateMap(const CalibrationPlate& plate) : plate_(plate) {
    const Eigen::Matrix2Xd& points = plate.plan.positions;
    low_ = points.rowwise().minCoeff().array() - kPlateFrame;
    size_ = points.rowwise().maxCoeff().array() + kPlateFrame - low_.array();
  }

  std::string svg() const {
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.2f}mm\" height=\"{1:.2f}mm\" "
        "viewBox=\"0 0 {0:.2f} {1:.2f}\" font-family=\"sans-serif\" font-size=\"4\">\n",
        size_.x(), size_.y());
    for (const Specimen& specimen : plate_.specimens) text += chain(specimen);
    return text + ruler() + "</svg>\n";
  }

 private:
  Vector2d at(const Vector2d& point) const {
    return {point.x() - low_.x(), size_.y() - (point.y() - low_.y())};
  }

  std::string chain(const Specimen& specimen) const {
    const PrintPlan& plan = plate_.plan;
    const auto hub = [&](int n) { return at(plan.positions.col(specimen.firstHub + n)); };
    const Vector2d first = hub(0);
    const Vector2d last = hub(specimen.struts);
    std::string text = fmt::format(
        "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"{}\" "
        "stroke-width=\"{:.2f}\"/>\n",
        first.x(), first.y(), last.x(), last.y(), shareColour(specimen.shareAlong),
        plan.strutWidth());
    for (int n = 0; n <= specimen.struts; ++n) {
      const Vector2d centre = hub(n);
      text += fmt::format(
          "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"#fff\" stroke=\"#888\" "
          "stroke-width=\"{:.2f}\"/>\n",
          centre.x(), centre.y(), (plan.hub.diameter + plan.hub.hole) / 4,
          (plan.hub.diameter - plan.hub.hole) / 2);
      if (!specimen.tubes.empty()) text += word(centre + Vector2d(-1, 6), tubeName(n));
    }
    const Vector2d number = first + 6 * (first - last).normalized() + Vector2d(-2, 1.5);
    return text + word(number, fmt::format("{}", specimen.number));
  }

  static std::string tubeName(int hub) { return {static_cast<char>('a' + hub)}; }

  static std::string word(const Vector2d& at, const std::string& text) {
    return fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\">{}</text>\n", at.x(), at.y(), text);
  }

  std::string ruler() const {
    const double bottom = size_.y() - 3;
    return fmt::format(
               "<line x1=\"3\" y1=\"{0:.2f}\" x2=\"{1:.2f}\" y2=\"{0:.2f}\" stroke=\"#000\" "
               "stroke-width=\"0.4\"/>\n",
               bottom, 3 + kPlateRuler) +
           word({5 + kPlateRuler, bottom + 1}, fmt::format("{:g} mm", kPlateRuler));
  }

  const CalibrationPlate& plate_;
  Vector2d low_, size_;
};

std::string calibrationSteps(const CalibrationPlate& plate) {
  const PrintPlan& plan = plate.plan;
  const PrintMaterial& material = plan.material;
  return fmt::format(
      "<ol>\n"
      "<li>Print calibration.gcode with the filament, the temperatures and the printer that the "
      "grids will get. The first passes are {:.2f} mm thin: level the bed.</li>\n"
      "<li>Take the specimens off; leave the numbers on, they tell them apart.</li>\n"
      "<li>Put a piece of {:g} mm pin through every hub and tube, as in a grid: it keeps rings "
      "from closing.</li>\n"
      "<li>Lay them loosely into water of {:g} degrees C, above {:g}, until nothing moves; let "
      "them cool lying flat.</li>\n"
      "<li>Write into measured.csv, in mm: <b>length_after_mm</b>, of each chain from hole to hole "
      "of its first and last hub, the same side of both (over the two pins outside, less the "
      "diameter of a pin); <b>height_after_mm</b>, of chains laid along or across (red or blue) "
      "that of a strut in its middle; of the hubs with tubes, a to f, that of hub and tube "
      "together, without the pin. What cannot be measured stays empty.</li>\n"
      "<li>Mark with x, in the column flattest, the chain that lies flattest: compare those of 24 "
      "mm laid along, two of which have passes that grow less and more than the others.</li>\n"
      "<li>morphgrid calibrate fit measured.csv --printer ... --material ...</li>\n</ol>\n",
      material.heightOf(0), plan.request.pin, material.bath, material.glassTransition);
}

}  // namespace

std::string calibrationPage(const CalibrationPlate& plate, const TierFigures& figures) {
  const PrintPlan& plan = plate.plan;
  return fmt::format(
             "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>{0}</title>\n"
             "{1}<h1>{0}</h1>\n<p>Printer: {2}. {3} specimens, {4:.1f} g, {5:.1f} h.</p>\n",
             htmlText(plan.name), kPlateStyle, htmlText(plan.printer.name), plate.specimens.size(),
             figures.grams, figures.seconds / 3600) +
         calibrationSteps(plate) +
         "<p>The map is at 1:1 when printed at 100 %: measure the line. Blue is laid across the "
         "strut, red along it.</p>\n<figure>\n" +
         PlateMap(plate).svg() + "</figure>\n</html>\n";
}

TierFigures writeCalibrationFiles(const CalibrationPlate& plate,
                                  const std::filesystem::path& folder, bool isPlain) {
  const std::filesystem::path table = folder / "measured.csv";
  const std::string blank = measurementsText(rowsOf(plate));
  if (std::filesystem::exists(table) && readFile(table) != blank) {
    throw InputError(
        fmt::format("{}: is there and holds something else, measurements perhaps: remove it, or "
                    "name another folder with --out",
                    table.string()));
  }
  PendingFiles files;
  const TierGcode gcode = writeCalibration(plate, isPlain);
  files.write(folder / "calibration.gcode", gcode.text);
  files.write(folder / "calibration.html", calibrationPage(plate, gcode.figures));
  files.write(table, blank);
  files.commit();
  return gcode.figures;
}

}  // namespace morphgrid
