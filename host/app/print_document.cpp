#include "app/print_document.h"

#include <fmt/format.h>

#include "core/document_toml_key.h"
#include "print/print_material.h"
#include "print/printer.h"
#include "report/generated_block.h"

namespace morphgrid {
namespace {

template <typename Record>
std::string withTables(std::string document, const char* file,
                       const std::vector<TomlKeySection<Record>>& sections) {
  const RecordKinds<Record> kinds{{}, [](std::size_t) { return Record(); }};
  const KeyDocument<Record> tables(kinds);
  for (const TomlKeySection<Record>& section : sections) {
    const std::string where =
        section.name.empty() ? std::string(file) : fmt::format("{}: [{}]", file, section.name);
    document = withBlock(document, fmt::format("keys of {}", where), tables.table(section.keys));
  }
  return document;
}

}  // namespace

std::string withPrintKeys(std::string document) {
  document = withTables(std::move(document), "printer files", printerKeys());
  return withTables(std::move(document), "material files", printMaterialKeys());
}

}  // namespace morphgrid
