// Ties a row of the schema to the member that holds its value.
#pragma once

#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "config/schema.hpp"

namespace frit::config {

template <class Owner>
Owner& owner_in(Target& target) {
  if constexpr (std::is_same_v<Owner, TemperatureStep>) {
    return *target.step;
  } else if constexpr (std::is_same_v<Owner, ParticleGroup>) {
    return *target.group;
  } else {
    return target.whole;
  }
}

template <class T>
struct OptionalEnum : std::false_type {};
template <class E>
struct OptionalEnum<std::optional<E>> : std::is_enum<E> {
  using type = E;
};

template <class T>
struct EnumList : std::false_type {};
template <class E>
struct EnumList<std::vector<E>> : std::is_enum<E> {
  using type = E;
};

template <class Owner, auto... Members>
Slot slot_of() {
  using T = std::remove_reference_t<decltype((std::declval<Owner&>().*....*Members))>;
  if constexpr (std::is_enum_v<T>) {
    return ChoiceAccess{
        [](Target& target) {
          return std::optional(static_cast<int>((owner_in<Owner>(target).*....*Members)));
        },
        [](Target& target, int index) { (owner_in<Owner>(target).*....*Members) = static_cast<T>(index); }};
  } else if constexpr (OptionalEnum<T>::value) {
    return ChoiceAccess{[](Target& target) {
                          const T& value = (owner_in<Owner>(target).*....*Members);
                          return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
                        },
                        [](Target& target, int index) {
                          (owner_in<Owner>(target).*....*Members) =
                              static_cast<typename OptionalEnum<T>::type>(index);
                        }};
  } else if constexpr (EnumList<T>::value) {
    return ChoiceListAccess{[](Target& target) {
                              std::vector<int> indices;
                              for (const auto value : (owner_in<Owner>(target).*....*Members))
                                indices.push_back(static_cast<int>(value));
                              return indices;
                            },
                            [](Target& target, const std::vector<int>& indices) {
                              T& values = (owner_in<Owner>(target).*....*Members);
                              values.clear();
                              for (const int index : indices)
                                values.push_back(static_cast<typename EnumList<T>::type>(index));
                            }};
  } else {
    return Access<T>([](Target& target) -> T& { return (owner_in<Owner>(target).*....*Members); });
  }
}

// in_case<&Case::cell, &CellSettings::kind>()
template <auto... Members>
Slot in_case() {
  return slot_of<Case, Members...>();
}
template <auto Member>
Slot in_step() {
  return slot_of<TemperatureStep, Member>();
}
template <auto Member>
Slot in_group() {
  return slot_of<ParticleGroup, Member>();
}

}  // namespace frit::config
