#include "print/print_material.h"

#include <fmt/format.h>

#include "core/key_place.h"
#include "core/read_toml_key.h"
#include "core/write_toml_keys.h"
#include "print/print_file_kind.h"

namespace morphgrid {
namespace {

using Material = PrintMaterial;
using MaterialKey = TomlKey<Material>;
using MaterialSection = TomlKeySection<Material>;

constexpr NumberRange kSpeeds = fromTo(1, 1000);
constexpr NumberRange kPassHeights = fromTo(0.01, 2);
constexpr IntegerRange kFewCounts{1, 1000};
constexpr const char* kErrorMeaning =
    "Standard error of `change`, as `calibrate fit` finds it; 0: not known.";
constexpr NumberRange kChanges{.low = -0.9, .high = 10, .lowIncluded = true, .highIncluded = true};

MaterialKey requiredText(const char* name, std::string Material::*text, const char* meaning) {
  return {.name = name, .value = textKey(at(text)), .isRequired = true, .meaning = meaning};
}

MaterialKey temperatureKey(const char* name, double Material::*value, const NumberRange& range,
                           bool isRequired, const char* meaning) {
  return {.name = name,
          .value = numberKey(at(value), range),
          .unit = "degrees C",
          .isRequired = isRequired,
          .meaning = meaning};
}

MaterialSection materialTopKeys() {
  return {"",
          {requiredText("name", &Material::name, "What reports call it."),
           requiredText("source", &Material::source, "Where the changes were measured."),
           {.name = "year",
            .value = integerKey(at(&Material::year), {1900, 2200}),
            .isRequired = true,
            .meaning = "When."},
           requiredText("caveat", &Material::caveat,
                        "How far they can be trusted; shown in every report."),
           {.name = "density",
            .value = numberKey(at(&Material::density), fromTo(0.1, 25)),
            .unit = "g/cm^3",
            .meaning = ""},
           temperatureKey("glass_transition", &Material::glassTransition, fromTo(1, 300), false,
                          "Where it becomes soft. Below the bath's."),
           temperatureKey("bath", &Material::bath, fromTo(1, 300), false,
                          "Of the water in which it morphs."),
           temperatureKey("nozzle_temperature", &Material::nozzleTemperature, fromTo(100, 500),
                          true, ""),
           temperatureKey("bed_temperature", &Material::bedTemperature, fromTo(0, 200), true,
                          "0: it stays cold."),
           {.name = "fan",
            .value = numberKey(at(&Material::fan), fromTo(0, 1)),
            .unit = "share",
            .meaning = "Of its full speed."}}};
}

MaterialSection strutKeys() {
  using Passes = Material::StrutPasses;
  return {"strut",
          {{.name = "lines",
            .value = integerKey(at(&Material::strut, &Passes::lines), {3, 99}),
            .meaning = "Beside each other. Odd, since a zone begins on one side and ends on the "
                       "other."},
           {.name = "passes",
            .value = integerKey(at(&Material::strut, &Passes::passes), kFewCounts),
            .isRequired = true,
            .meaning = "On top of each other."},
           {.name = "pass_height",
            .value = numberKey(at(&Material::strut, &Passes::passHeight), kPassHeights),
            .unit = "mm",
            .isRequired = true,
            .meaning = "In the middle pass."},
           {.name = "height_step",
            .value = numberKey(at(&Material::strut, &Passes::heightStep), fromTo(-1, 1)),
            .unit = "mm",
            .meaning = "By how much each pass is higher than the one below, against curling."}}};
}

MaterialSection layKeys(const char* name, Lay Material::*lay, const char* lines) {
  return {
      name,
      {{.name = "speed",
        .value = numberKey(at(lay, &Lay::speed), kSpeeds),
        .unit = "mm/s",
        .meaning = ""},
       {.name = "change",
        .value = numberKey(at(lay, &Lay::change), kChanges),
        .unit = "share",
        .isRequired = true,
        .meaning = fmt::format("What the bath does to the length of a strut whose lines run {} it; "
                               "-0.42 makes it 42 % shorter.",
                               lines)},
       {.name = "error",
        .value = numberKey(at(lay, &Lay::error), fromTo(0, 1)),
        .unit = "share",
        .meaning = kErrorMeaning},
       {.name = "height_change",
        .value = numberKey(at(lay, &Lay::heightChange), kChanges),
        .unit = "share",
        .isRequired = true,
        .meaning = "What it does to its height."}}};
}

MaterialSection hubKeys() {
  using Hub = Material::HubRings;
  return {"hub",
          {{.name = "every",
            .value = integerKey(at(&Material::hub, &Hub::every), kFewCounts),
            .unit = "passes",
            .meaning = "Rings are laid every so many passes, and are as many times higher."},
           {.name = "speed",
            .value = numberKey(at(&Material::hub, &Hub::speed), kSpeeds),
            .unit = "mm/s",
            .meaning = ""},
           {.name = "change",
            .value = numberKey(at(&Material::hub, &Hub::change), kChanges),
            .unit = "share",
            .meaning = "What the bath does to the diameter; the pin stops it."},
           {.name = "error",
            .value = numberKey(at(&Material::hub, &Hub::error), fromTo(0, 1)),
            .unit = "share",
            .meaning = kErrorMeaning},
           {.name = "height_change",
            .value = numberKey(at(&Material::hub, &Hub::heightChange), kChanges),
            .unit = "share",
            .meaning = "What it does to the height."},
           {.name = "measured",
            .value = booleanKey(at(&Material::hub, &Hub::isMeasured)),
            .meaning = "Whether somebody measured that; else reports warn."}}};
}

MaterialSection tubeKeys() {
  using Tube = Material::TubeRings;
  return {"tube",
          {{.name = "pass_height",
            .value = numberKey(at(&Material::tube, &Tube::passHeight), kPassHeights),
            .unit = "mm",
            .meaning = "Rounded, so that passes fill the tube's height."},
           {.name = "speed",
            .value = numberKey(at(&Material::tube, &Tube::speed), kSpeeds),
            .unit = "mm/s",
            .meaning = ""},
           {.name = "change",
            .value = numberKey(at(&Material::tube, &Tube::change), kChanges),
            .unit = "share",
            .meaning = "What the bath does to the height."},
           {.name = "error",
            .value = numberKey(at(&Material::tube, &Tube::error), fromTo(0, 1)),
            .unit = "share",
            .meaning = kErrorMeaning},
           {.name = "measured",
            .value = booleanKey(at(&Material::tube, &Tube::isMeasured)),
            .meaning = "As of `[hub]`."}}};
}

void checkMaterial(TomlReader& reader, const Material& material) {
  TomlSection strut = reader.section("strut");
  const auto refuse = [&](const TomlSection& section, const char* key, const std::string& must) {
    reader.problems.add(section.place(key), section.fullName(key) + " must " + must);
  };
  if (material.strut.lines % 2 == 0) {
    refuse(strut, "lines", fmt::format("be odd, got {}", material.strut.lines));
  }
  if (std::min(material.heightOf(0), material.heightOf(material.strut.passes - 1)) <= 0) {
    refuse(strut, "height_step",
           fmt::format("leave every pass a height, got {:.4g}", material.strut.heightStep));
  }
  if (material.along.change >= material.across.change) {
    refuse(reader.section("along"), "change",
           fmt::format("be below across.change, {:.4g}, got {:.4g}", material.across.change,
                       material.along.change));
  }
  if (material.glassTransition >= material.bath) {
    refuse(reader.root(), "bath",
           fmt::format("be above glass_transition, {:.4g}, got {:.4g}", material.glassTransition,
                       material.bath));
  }
}

}  // namespace

const std::vector<TomlKeySection<PrintMaterial>>& printMaterialKeys() {
  static const std::vector<MaterialSection> kSections{
      materialTopKeys(),
      strutKeys(),
      layKeys("along", &Material::along, "along"),
      layKeys("across", &Material::across, "across"),
      hubKeys(),
      tubeKeys()};
  return kSections;
}

std::string printMaterialText(const PrintMaterial& material) {
  return TomlKeyWriter(material).write(printMaterialKeys());
}

PrintMaterial readPrintMaterial(const std::filesystem::path& file) {
  TomlReader reader(file, parseToml(file));
  requireKind(PrintFileKind::material, file, reader.document());
  PrintMaterial material;
  readSections(reader, printMaterialKeys(), material);
  if (reader.problems.empty()) checkMaterial(reader, material);
  reader.reportUnknownKeys();
  reader.problems.throwIfAny();
  return material;
}

}  // namespace morphgrid
