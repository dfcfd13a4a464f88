#pragma once
#include <type_traits>

#include "core/toml_key.h"

namespace morphgrid {

/// Where in a record a value lies; null where this record has no such part.
template <typename Record, typename Value>
struct KeyPlace {
  std::function<const Value*(const Record&)> find;
  std::function<Value*(Record&)> make;  ///< Makes optional parts.
};

template <typename Record, typename Value>
KeyPlace<Record, Value> at(Value Record::*value) {
  return {[=](const Record& record) { return &(record.*value); },
          [=](Record& record) { return &(record.*value); }};
}

template <typename Record, typename Part, typename Base, typename Value>
KeyPlace<Record, Value> at(Part Record::*part, Value Base::*value) {
  return {[=](const Record& record) { return &(record.*part.*value); },
          [=](Record& record) { return &(record.*part.*value); }};
}

/// A value of an optional part, which is there once one of its values is.
template <typename Record, typename Part, typename Value>
KeyPlace<Record, Value> at(std::optional<Part> Record::*part, Value Part::*value) {
  return {[=](const Record& record) -> const Value* {
            return record.*part ? &((*(record.*part)).*value) : nullptr;
          },
          [=](Record& record) -> Value* {
            if (!(record.*part)) (record.*part).emplace();
            return &((*(record.*part)).*value);
          }};
}

/// A value of one alternative of a variant.
template <typename Part, typename Record, typename Variant, typename Value>
KeyPlace<Record, Value> within(Variant Record::*parts, Value Part::*value) {
  return {[=](const Record& record) -> const Value* {
            const auto* part = std::get_if<Part>(&(record.*parts));
            return part ? &(part->*value) : nullptr;
          },
          [=](Record& record) -> Value* {
            auto* part = std::get_if<Part>(&(record.*parts));
            return part ? &(part->*value) : nullptr;
          }};
}

/// A value of an optional part of one alternative; the part is there once one of its values is.
template <typename Part, typename Record, typename Variant, typename Inner, typename Value>
KeyPlace<Record, Value> within(Variant Record::*parts, std::optional<Inner> Part::*inner,
                               Value Inner::*value) {
  return {[=](const Record& record) -> const Value* {
            const auto* part = std::get_if<Part>(&(record.*parts));
            return part && part->*inner ? &((*(part->*inner)).*value) : nullptr;
          },
          [=](Record& record) -> Value* {
            auto* part = std::get_if<Part>(&(record.*parts));
            if (!part) return nullptr;
            if (!(part->*inner)) (part->*inner).emplace();
            return &((*(part->*inner)).*value);
          }};
}

template <typename Value>
struct OptionalValue : std::false_type {};
template <typename Value>
struct OptionalValue<std::optional<Value>> : std::true_type {};

/// Read and written as a Value, whatever type lies there, an optional one too.
template <typename Value, typename Record, typename Held>
KeyAccess<Record, Value> accessTo(KeyPlace<Record, Held> place) {
  return {[find = place.find](const Record& record) -> std::optional<Value> {
            const Held* held = find(record);
            if constexpr (OptionalValue<Held>::value) {
              return held && *held ? std::optional(static_cast<Value>(**held)) : std::nullopt;
            } else {
              return held ? std::optional(static_cast<Value>(*held)) : std::nullopt;
            }
          },
          [make = place.make](Record& record, const Value& value) {
            if (Held* held = make(record)) {
              if constexpr (OptionalValue<Held>::value) {
                *held = static_cast<typename Held::value_type>(value);
              } else {
                *held = static_cast<Held>(value);
              }
            }
          }};
}

template <typename Record, typename Held>
NumberKey<Record> numberKey(KeyPlace<Record, Held> place, const NumberRange& range = {}) {
  return {accessTo<double>(std::move(place)), range};
}

template <typename Record, typename Held>
IntegerKey<Record> integerKey(KeyPlace<Record, Held> place, const IntegerRange& range) {
  return {accessTo<std::int64_t>(std::move(place)), range};
}

template <typename Record, typename Held>
BooleanKey<Record> booleanKey(KeyPlace<Record, Held> place) {
  return {accessTo<bool>(std::move(place))};
}

/// words: in the order of the enumeration's values.
template <typename Record, typename Held, typename Words>
WordKey<Record> wordKey(KeyPlace<Record, Held> place, const Words& words) {
  return {accessTo<std::size_t>(std::move(place)), {std::begin(words), std::end(words)}};
}

template <typename Record, typename Held>
TextKey<Record> textKey(KeyPlace<Record, Held> place) {
  return {accessTo<std::string>(std::move(place))};
}

template <typename Record>
NumberPairKey<Record> numberPairKey(KeyPlace<Record, double> first, KeyPlace<Record, double> second,
                                    const NumberRange& range) {
  using Pair = std::array<double, 2>;
  return {{[=](const Record& record) -> std::optional<Pair> {
             const double* one = first.find(record);
             const double* other = second.find(record);
             return one && other ? std::optional(Pair{*one, *other}) : std::nullopt;
           },
           [=](Record& record, const Pair& pair) {
             if (double* one = first.make(record)) *one = pair[0];
             if (double* other = second.make(record)) *other = pair[1];
           }},
          range};
}

template <typename Record, typename Held>
FileKey<Record> fileKey(KeyPlace<Record, Held> place, std::string what = "file",
                        std::string hint = "") {
  return {accessTo<std::filesystem::path>(std::move(place)), std::move(what), std::move(hint)};
}

}  // namespace morphgrid
