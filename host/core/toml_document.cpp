#include "core/toml_document.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "core/problem_list.h"
#include "core/read_file.h"
#include "core/toml_nesting.h"

namespace morphgrid {
namespace {

constexpr std::string_view kOverride = "--set ";

/// toml++ says "Error while parsing ..." or "Encountered ...".
std::string explain(const toml::parse_error& error) {
  std::string text(error.description());
  const std::string prefix = "Error ";
  if (text.rfind(prefix, 0) == 0) text.erase(0, prefix.size());
  if (text.rfind("Enc", 0) == 0) text.front() = 'e';
  return "not valid TOML: " + text;
}

// Scenes have some kilobytes, those that runs leave a little more.
constexpr std::uintmax_t kMostTomlBytes = 1 << 24;

/// Throws where the parser would recurse too deep. place: of the text's first byte.
void refuseDeepNesting(std::string_view text, Place place) {
  if (const auto found = findTooDeepNesting(text)) {
    if (place.line > 0) place = {place.source, found->line, found->column};
    throw InputError(fmt::format("{}: more than {} levels of arrays, tables and dotted keys",
                                 toString(place), kMostTomlLevels));
  }
}

toml::table parseText(const std::string& text, const std::filesystem::path& file) {
  refuseDeepNesting(text, {file.string(), 1, 1});
  try {
    return toml::parse(std::string_view(text), file.string());
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}: {}", toString(placeOf(error.source())), explain(error)));
  }
}

toml::table parseFile(const std::filesystem::path& file) {
  return parseText(readFile(file, kMostTomlBytes), file);
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// `key = 'value'` for a value whose author, used to shells, left out the quotes.
std::optional<std::string> withQuotes(std::string_view assignment, std::size_t equals) {
  const std::string_view value = trimmed(assignment.substr(equals + 1));
  const bool opensSomething = std::string_view("[{\"").find(value.front()) != value.npos;
  if (opensSomething || value.find('\'') != value.npos) return std::nullopt;
  return fmt::format("{} = '{}'", assignment.substr(0, equals), value);
}

toml::table parseOverride(const std::string& assignment) {
  const std::string source = std::string(kOverride) + assignment.substr(0, assignment.find('\n'));
  const std::size_t equals = assignment.find('=');
  const bool oneLine = assignment.find('\n') == std::string::npos;
  if (!oneLine || equals == std::string::npos ||
      trimmed(std::string_view(assignment).substr(equals + 1)).empty()) {
    throw InputError(source + ": must be key=value on one line, e.g. grid.layers=4");
  }
  refuseDeepNesting(assignment, {source});
  try {
    return toml::parse(std::string_view(assignment), source);
  } catch (const toml::parse_error& error) {
    try {
      if (const auto quoted = withQuotes(assignment, equals)) {
        return toml::parse(std::string_view(*quoted), source);
      }
    } catch (const toml::parse_error&) {  // Not the value's fault: the first error tells more.
    }
    throw InputError(fmt::format("{}: {}", source, explain(error)));
  }
}

void merge(toml::table& into, toml::table&& from) {
  for (auto&& [key, node] : from) {
    toml::table* old = into[key.str()].as_table();
    if (old && node.is_table()) {
      merge(*old, std::move(*node.as_table()));
      continue;
    }
    into.erase(key.str());  // The key carries its place: assigning alone would keep the old one.
    // Moving keeps a node's place, copying does not.
    node.visit([&, &place = key](auto& typed) { into.insert(place, std::move(typed)); });
  }
}

using Chain = std::vector<std::filesystem::path>;

/// The file that the last of a chain extends, if it does. What is no string is left to those who
/// read the document.
std::optional<std::filesystem::path> baseOf(const toml::table& document, const Chain& chain) {
  const toml::node* name = document.get("extends");
  if (!name || !name->is_string()) return std::nullopt;
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("{}: extends {}", toString(placeOf(name->source())), why));
  };
  const auto base = chain.back().parent_path() / name->as_string()->get();
  if (const auto reason = whyUnreadable(base)) {
    refuse(fmt::format("must name a readable file, got {}: {}", base.string(), *reason));
  }
  for (const auto& file : chain) {
    std::error_code ignored;  // Both are readable.
    if (std::filesystem::equivalent(base, file, ignored)) {
      refuse(fmt::format("must not lead back to {}", file.string()));
    }
  }
  return base;
}

/// Puts a document over what it extends. chain: its file, after those that extend it; those that it
/// extends are added.
toml::table overBase(toml::table document, Chain& chain) {
  const auto base = baseOf(document, chain);
  if (!base) return document;
  chain.push_back(*base);
  toml::table whole = overBase(parseFile(*base), chain);
  merge(whole, std::move(document));
  return whole;
}

}  // namespace

bool isOverride(const toml::source_region& source) {
  return source.path && source.path->starts_with(kOverride);
}

Place placeOf(const toml::source_region& source) {
  const std::string path = source.path ? *source.path : "";
  if (isOverride(source)) return {path};
  return {path, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

namespace {

/// parse: gives the document that the overrides change.
template <typename Parse>
toml::table withOverrides(const Parse& parse, const std::vector<std::string>& overrides) {
  ProblemList problems;
  toml::table document;
  try {
    document = parse();
  } catch (const InputError& error) {
    problems.add(error);
  }
  for (const std::string& assignment : overrides) {
    try {
      merge(document, parseOverride(assignment));
    } catch (const InputError& error) {
      problems.add(error);
    }
  }
  problems.throwIfAny();
  return document;
}

}  // namespace

toml::table parseTomlAlone(const std::filesystem::path& file,
                           const std::vector<std::string>& overrides) {
  return withOverrides([&] { return parseFile(file); }, overrides);
}

toml::table parseTomlText(const std::string& text, const std::filesystem::path& file,
                          const std::vector<std::string>& overrides) {
  return withOverrides([&] { return parseText(text, file); }, overrides);
}

toml::table parseToml(const std::filesystem::path& file,
                      const std::vector<std::string>& overrides) {
  Chain chain = {file};
  return overBase(parseTomlAlone(file, overrides), chain);
}

std::vector<std::filesystem::path> listTomlFiles(const std::filesystem::path& file,
                                                 const std::vector<std::string>& overrides) {
  Chain chain = {file};
  overBase(parseTomlAlone(file, overrides), chain);
  return chain;
}

}  // namespace morphgrid
